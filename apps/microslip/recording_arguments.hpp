// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/recordings.hpp"

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

/// On standard error. Nobody may listen: that is no error.
void show_warnings(const std::vector<Warning>& warnings);

}  // namespace microslip::app
