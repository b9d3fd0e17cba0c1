// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/identify/inversion/inversion_options.hpp"
#include "microslip/identify/inversion/inversion_result.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// Identifies the slip-force density from measured dissipation by solving (7) for it,
///
///     minimise ½‖W(Kθ + βA² − D)‖² + ½λ‖Lθ‖²  subject to  θ ≥ 0, β ≥ 0, ∫φ df* ≤ 1,
///
/// φ = Σθ_jN_j on knots that follow the data (InversionBasis). W is 1/σ of LevelEvidence, with
/// D from a first fit. The penalty is on second differences of θ, weaker where a first pass found
/// little density, so that empty ranges stay empty and peaks are not flattened. Secant stiffnesses
/// add rows of the same θ, each minus the weighted mean of them all: their change over the
/// amplitude is used, their absolute level is not, as it stands and falls with k. Differences
/// between levels of equal amplitude count as scatter.
///
/// @param evidence   at least kFewestLevels different amplitudes.
/// @param stiffness  k of the stuck joint, N/m; > 0. It scales the slip forces: f* = kA.
/// @param options    how it is solved.
/// @throws InputError  naming the level or option that breaks a rule.
[[nodiscard]] InversionResult invert(const LevelEvidence& evidence, double stiffness,
                                     const InversionOptions& options = {});

}  // namespace microslip
