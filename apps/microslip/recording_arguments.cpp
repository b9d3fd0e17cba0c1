// SPDX-License-Identifier: MIT
#include "recording_arguments.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "microslip/io/assumed_units.hpp"

namespace microslip::app {

void add_recording_arguments(CLI::App& command, RecordingArguments& arguments) {
  command
      .add_option("--assume-units", arguments.assumed_units,
                  "CHANNEL=UNIT: what a channel without unit is in; may be repeated. SI: each one "
                  "whose quantity the file names (force, acceleration, acc1, time, ...) is in SI")
      ->allow_extra_args(false);
  command.add_flag("--allow-truncated", arguments.allow_truncated,
                   "Take what is there of a file that was cut");
}

RecordingReadOptions read_options(const RecordingArguments& arguments, Progress progress) {
  return {.allow_truncated = arguments.allow_truncated,
          .progress = std::move(progress),
          .assumed_units = parse_assumed_units(arguments.assumed_units)};
}

void show_warnings(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    const std::string text = fmt::format("microslip: warning: {}\n", warning.text);
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace microslip::app
