// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/inversion/level_design.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// Arguments of design_levels(), from levels and draws of their posterior.

namespace microslip {

/// The same levels, and one more that carries no information, with 100 times its D as standard
/// deviation: draws of their posterior extend to its amplitude, where only the prior and Φ0 ≤ 1
/// limit them. The others have the standard deviations that `result` found.
/// @param evidence   the levels.
/// @param result     of invert() of them.
/// @param stiffness  k, N/m.
/// @param amplitude  above all levels, m.
/// @throws InputError  where the amplitude is not above all levels.
[[nodiscard]] LevelEvidence reaching_to(const LevelEvidence& evidence,
                                        const InversionResult& result, double stiffness,
                                        double amplitude);

/// Further levels at candidate amplitudes, measured as the existing ones. σ_D/D and σ_k of a
/// level are the deviations of the existing levels, interpolated linearly over ln A and constant
/// beyond, times the scatter found; of D 0.01 % at least. k_eq counts where it was measured, minus
/// its mean, as in invert().
/// @param evidence   the levels.
/// @param result     of invert() of them.
/// @param joints     drawn_joints().
/// @param amplitude  candidates, m; rising, > 0.
[[nodiscard]] FurtherLevels further_levels(const LevelEvidence& evidence,
                                           const InversionResult& result,
                                           std::span<const Joint> joints,
                                           const std::vector<double>& amplitude);

/// φ in the middle of each of 40 equal parts of a range, 1/N; S is the mean standard deviation.
/// @param joints  draws.
/// @param range   of slip forces, N; from below to.
[[nodiscard]] DesignTarget density_target(std::span<const Joint> joints,
                                          std::pair<double, double> range);

/// ∫φ df* over a range, the fraction of k that slips there, 1.
/// @param joints  draws.
/// @param range   of slip forces, N.
[[nodiscard]] DesignTarget area_target(std::span<const Joint> joints,
                                       std::pair<double, double> range);

}  // namespace microslip
