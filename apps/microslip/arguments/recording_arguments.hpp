// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"

/// @file
/// Options common to the subcommands that read recordings.

namespace microslip::app {

struct RecordingArguments {
  std::vector<std::string> assumed_units;
  bool allow_truncated = false;
  std::string rate;
};

/// Adds --assume-units, --allow-truncated and --rate.
void add_recording_arguments(CLI::App& command, RecordingArguments& arguments);

/// @throws InputError  where a unit is none, or the rate no frequency above 0.
[[nodiscard]] RecordingReadOptions read_options(const RecordingArguments& arguments,
                                                Progress progress = {});

/// --frequency: nothing where it is empty.
/// @throws InputError  where it is no frequency above 0.
[[nodiscard]] std::optional<double> frequency_guess(const std::string& text);

/// Prints on standard error. A closed stream is not an error.
void show_warnings(const std::vector<Warning>& warnings);

}  // namespace microslip::app
