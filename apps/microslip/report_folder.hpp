// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/workflow/experiment_results.hpp"

namespace microslip::app {

/// So many records a report shows over time if nothing else is asked for.
inline constexpr std::size_t kRecordsOverTime = 8;

/// What a folder has of a test: levels.csv, joint.json, density.csv, rig.toml, truth_joint.json,
/// truth.csv, force_control.csv, verification.csv, verification_histories.csv and
/// recordings/level_*. Each may be missing. A recording that cannot be read is a warning, anything
/// else an error.
/// @param records  so many recordings are shown over time, all others by their harmonics; 0 reads
///                 none.
/// @throws FileError, FormatError, InputError  as the readers of these files.
[[nodiscard]] ExperimentResults read_test_folder(const std::string& folder, bool quiet,
                                                 std::size_t records = 0);

/// Adds what one of these files holds, by its kind (io/file_kind): levels, a joint, a verification,
/// histories of one, a force control.
/// @return whether it is one of these.
/// @throws FormatError, InputError  as the readers of these files.
[[nodiscard]] bool add_test_file(const std::string& kind, const std::string& text,
                                 const std::string& path, ExperimentResults& results);

}  // namespace microslip::app
