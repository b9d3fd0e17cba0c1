// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings.hpp"
#include "microslip/signal/recording.hpp"

/// @file
/// What the subcommands that read recordings share.

namespace microslip::app {

struct RecordingArguments {
  std::vector<std::string> assumed_units;
  bool allow_truncated = false;
};

/// Adds --assume-units and --allow-truncated.
void add_recording_arguments(CLI::App& command, RecordingArguments& arguments);

/// @throws InputError  where a unit is none.
[[nodiscard]] RecordingReadOptions read_options(const RecordingArguments& arguments,
                                                Progress progress = {});

/// The records of a file, each named as the file was by the caller, not as the one that it was made
/// from; with the name of the recording where it holds several.
/// @param warnings  gets what the reader had to forgive.
/// @throws Error  as read_recordings().
[[nodiscard]] std::vector<Recording> read_named_recordings(const std::string& path,
                                                           const RecordingReadOptions& options,
                                                           std::vector<Warning>& warnings);

/// --frequency: nothing where it is empty.
/// @throws InputError  where it is no frequency above 0.
[[nodiscard]] std::optional<double> frequency_guess(const std::string& text);

/// What the readers of many recordings had to forgive, in one list, without what is said twice; of
/// very many the first, and how many there are.
[[nodiscard]] std::vector<Warning> joined_warnings(
    const std::vector<std::vector<Warning>>& warnings);

/// On standard error. Nobody may listen: that is no error.
void show_warnings(const std::vector<Warning>& warnings);

}  // namespace microslip::app
