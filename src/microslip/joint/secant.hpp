// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/joint.hpp"

/// @file
/// First-harmonic equivalent (describing function) of a joint in a steady cycle x = A cos θ:
///
///     k_eq(A) = (1/(πA)) ∮ f cos θ dθ = k[1 − Φ0(kA)] + k ∫₀^{kA} φ(f*) g(f*/(kA)) df*
///     g(ρ)    = (θ_c − ½ sin 2θ_c)/π,  θ_c = arccos(1 − 2ρ),  g′(ρ) = (8/π)√(ρ(1 − ρ))
///
/// g is the share of its stiffness that one Jenkins element keeps when it slips at ρA < A; k_eq is
/// linear in φ, as D is. Amplitudes are in m and finite; the functions throw InputError otherwise.

namespace microslip {

/// g(ρ), 1. @param rho  slip displacement over amplitude, 1; clipped to [0, 1].
[[nodiscard]] double jenkins_secant(double rho);

/// Secant stiffness k_eq(A), N/m; k at A = 0. @param joint  any. @param amplitude  A, ≥ 0.
[[nodiscard]] double secant_stiffness(const Joint& joint, double amplitude);

/// Loss factor D/(π k_eq A²), 1; 0 at A = 0. @param joint  any. @param amplitude  A, ≥ 0.
[[nodiscard]] double loss_factor(const Joint& joint, double amplitude);

}  // namespace microslip
