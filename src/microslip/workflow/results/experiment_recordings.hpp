// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/base/progress.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip {

/// Of all signals over time, in recordings as in predictions: about 0.7 MB of the report, unless a
/// signal has less than it takes to see it.
inline constexpr std::size_t kMostSignalPoints = 60000;

/// Adds the recordings level_* of a folder or of recordings/ in it, with those before_control_*
/// beside them: some over time, all by their harmonics unless they are large or many. One that
/// cannot be read is a warning.
/// @param records  so many over time; those with a record before control may be as many more.
/// @throws Cancelled
void add_recordings(const std::string& folder, std::size_t records, const Progress& progress,
                    ExperimentResults& results);

}  // namespace microslip
