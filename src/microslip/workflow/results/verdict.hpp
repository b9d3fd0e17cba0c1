// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/methods/method_comparison.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// How sure the results of a test are, and what to worry about.

namespace microslip {

/// Of the levels, those that the joint was identified from.
[[nodiscard]] std::size_t used_count(const MeasuredLevels& test);

/// The median half-width of the band over the covered slip forces, relative to the density, 1.
/// Nothing where there is no band.
[[nodiscard]] std::optional<double> typical_half_width(const IdentifiedJoint& found);

/// The part of an NRMSE that is no noise, √(NRMSE² − noise²), 1; 0 or more.
[[nodiscard]] double beyond_noise(const ChannelMisfit& row);

/// misfit_of_levels(), whoever identified the joint: "2.1 % of D, rms".
[[nodiscard]] std::string misfit_text(const ExperimentResults& results);

/// density_error() against the truth of a virtual test, 1. Nothing where the truth has no density
/// to compare with.
[[nodiscard]] std::optional<double> error_against_truth(const ExperimentResults& results);

/// Each warning once: of the files, of a joint that misses the levels or that they contradict, of
/// the methods, flags of predictions and of levels. The texts where the levels tell them again,
/// else those of the files, which older ones lack; of an identification from records all its
/// warnings, of each record.
/// @param methods  of these results, where there is one.
[[nodiscard]] std::vector<Warning> warnings_of(const ExperimentResults& results,
                                               const std::optional<MethodComparison>& methods);

}  // namespace microslip
