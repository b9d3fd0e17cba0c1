// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Results in joint.json of an identification from records of force and displacement, and of what
/// levels were tested for. Internal to workflow.

namespace microslip {

/// Nothing where the joint was not identified from records.
/// @param path  of the file, for messages.
/// @throws InputError  naming the key of which there are fewer or more values than records, or that
///                     names a record that is not there.
[[nodiscard]] std::optional<FoundByRecords> found_by_records(const JointFile& file,
                                                             const std::string& path);

/// Tests of the assumptions in an identification without records; empty where there is
/// nothing.
/// @throws InputError  naming the key of which there are fewer or more values than departures.
[[nodiscard]] std::vector<DepartureFound> departures_of_levels(const JointFile& file,
                                                               const std::string& path);

}  // namespace microslip
