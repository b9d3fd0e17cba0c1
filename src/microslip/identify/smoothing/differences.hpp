// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/identify/smoothing/signed_density.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// The density without any smoothing [AR14 (9), Fig. 9]: φ(kA_i) = D″_i/(4k²A_i) at each inner
/// level, with the three-point difference for unequal spacing
///
///     D″_i = 2/(h₋ + h₊) · [(D_{i+1} − D_i)/h₊ − (D_i − D_{i−1})/h₋]
///     h₋ = A_i − A_{i−1},  h₊ = A_{i+1} − A_i
///
/// of second order where the spacing is equal, of first order where it is not. Noise σ of D becomes
/// about 2.4σ/h² of D″: a baseline to compare with, not a result to use.
/// @param levels     with their errors; at least 3 distinct.
/// @param stiffness  k, N/m; positive and finite.
/// @return  one point per inner level; with standard deviations where `dissipation_std` is given.
/// @throws InputError  naming the level and the value that breaks a rule.
[[nodiscard]] SignedDensity density_by_differences(const LevelEvidence& levels, double stiffness);

}  // namespace microslip
