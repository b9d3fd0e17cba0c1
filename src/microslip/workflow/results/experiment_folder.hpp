// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip {

/// So many records are taken over time if nothing else is asked for.
inline constexpr std::size_t kRecordsOverTime = 8;

/// Results of a test in a folder: levels.csv, joint.json, density.csv, rig.toml, truth_joint.json,
/// truth.csv, force_control.csv, verification.csv, verification_histories.csv and
/// recordings/level_*. Each may be missing. A recording that cannot be read is a warning, anything
/// else an error.
/// @param folder    of the test.
/// @param records   so many recordings are taken over time, all others by their harmonics; 0 reads
///                  none.
/// @param progress  reports the recordings.
/// @throws FileError, FormatError, InputError  as the readers of these files.
/// @throws Cancelled  as the progress says.
[[nodiscard]] ExperimentResults read_experiment(const std::string& folder, std::size_t records = 0,
                                                const Progress& progress = {});

/// Folders in a folder that hold one of these files, sorted.
[[nodiscard]] std::vector<std::string> folders_holding(const std::string& folder,
                                                       std::initializer_list<const char*> files);

/// Adds what one of these files holds, by its kind (file_kind): levels, a joint, a verification,
/// histories of one, a force control.
/// @param kind     of the text.
/// @param text     of the file.
/// @param path     of it, for messages.
/// @param results  that get it.
/// @return whether it is one of these.
/// @throws FormatError, InputError  as the readers of these files.
[[nodiscard]] bool add_result_file(const std::string& kind, const std::string& text,
                                   const std::string& path, ExperimentResults& results);

}  // namespace microslip
