// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/joint.hpp"

/// @file
/// The energy that a joint dissipates in a steady cycle of amplitude A about any mean, with one
/// reversal at each end:
///
///     D(A)  = 4[AΦ1(kA) − Φ2(kA)/k] = ∫₀^{kA} 4f*(A − f*/k) φ df*          [AR14 (7)]
///     D′(A) = 4Φ1(kA)                                                    [AR14 (8)]
///     D″(A) = 4Ak²φ(kA)                                                  [AR14 (9)]
///
/// The inverse of (9), from measured D to φ, is in identify/. Amplitudes are in m, ≥ 0 and finite;
/// the functions throw InputError otherwise.

namespace microslip {

/// D(A), J per cycle.
[[nodiscard]] double dissipation(const Joint& joint, double amplitude);

/// D′(A), J/m. At an atom the value beyond it.
[[nodiscard]] double dissipation_slope(const Joint& joint, double amplitude);

/// D″(A), J/m², without the Dirac terms of atoms.
[[nodiscard]] double dissipation_curvature(const Joint& joint, double amplitude);

}  // namespace microslip
