// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/inversion/level_design.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// What design_levels() takes, from levels and draws of their posterior.

namespace microslip {

/// The same levels, and one more of which nothing is known, with 100 times its D as standard
/// deviation: draws of their posterior reach to its amplitude, and are there what the prior and
/// Φ0 ≤ 1 leave possible. The others have the standard deviations that `result` found.
/// @param evidence   the levels.
/// @param result     of invert() of them.
/// @param stiffness  k, N/m.
/// @param amplitude  above all levels, m.
/// @throws InputError  where it is not.
[[nodiscard]] LevelEvidence reaching_to(const LevelEvidence& evidence,
                                        const InversionResult& result, double stiffness,
                                        double amplitude);

/// What levels at some amplitudes would tell, measured as those that are there. A level has as
/// σ_D/D and σ_k what the deviations of the levels are at that amplitude, straight over ln A
/// between them and constant beyond, times the scatter that was found; of D 0.01 % at least. k_eq
/// counts where it was measured, less its mean, as in invert().
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

/// ∫φ df* over a range, the share of k that slips there, 1.
/// @param joints  draws.
/// @param range   of slip forces, N.
[[nodiscard]] DesignTarget area_target(std::span<const Joint> joints,
                                       std::pair<double, double> range);

}  // namespace microslip
