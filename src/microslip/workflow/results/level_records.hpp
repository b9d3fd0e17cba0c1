// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "microslip/rig/virtual_test/virtual_measurement.hpp"
#include "microslip/signal/recording/recording.hpp"
#include "microslip/workflow/results/experiment_results.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

/// @file
/// Recordings of the levels of a test.

namespace microslip {

/// The real channels of a steady vibration: their harmonics, from a Fourier series fitted to the
/// whole record, and two cycles of each over time, from where the fundamental of the first channel
/// rises through 0.
/// @param recording    over time.
/// @param name         of the record in the report.
/// @param most_points  of all channels together; a channel has 200 to 4000. 0 leaves the histories
///                     out.
/// @throws InputError  where it has no channel with a unit or holds no steady vibration.
[[nodiscard]] LevelRecord level_record(const Recording& recording, const std::string& name,
                                       std::size_t most_points);

/// Makes the channels of another record the other ones of those with the same names and units.
/// @param other   for instance before force control.
/// @param record  that gets them.
void add_other(const LevelRecord& other, LevelRecord& record);

/// Up to `count` of some names at even distances, the first and the last among them.
[[nodiscard]] std::vector<std::string> spread(const std::vector<std::string>& names,
                                              std::size_t count);

/// Up to `count` of the records, the first and the last among them, each n-th point of their
/// signals so that these have at most `most_points`.
[[nodiscard]] std::vector<LevelRecord> some_records(std::vector<LevelRecord> records,
                                                    std::size_t count, std::size_t most_points);

/// The harmonics of the force over the first, from the second, before and after its control.
/// @param levels     of a virtual test with a shaker.
/// @param harmonics  that were controlled.
[[nodiscard]] std::vector<ForceControlLevel> force_controls(std::span<const VirtualLevel> levels,
                                                            std::size_t harmonics);

/// F_1 … F_H of a force over one cycle, N over s.
/// @param driven  of a virtual test.
/// @param points  steps of the cycle.
[[nodiscard]] Curve force_over_cycle(const DrivenVibration& driven, std::size_t points);

}  // namespace microslip
