// SPDX-License-Identifier: MIT
#include "arguments/recording_arguments.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

/// Nothing where the text is empty.
std::optional<double> frequency_of(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const double frequency = parse_quantity(option, text, kFrequency);
  if (!(frequency > 0.0)) throw InputError(option, frequency, "must be above 0 Hz");
  return frequency;
}

}  // namespace

void add_recording_arguments(CLI::App& command, RecordingArguments& arguments) {
  command
      .add_option(
          "--assume-units", arguments.assumed_units,
          "CHANNEL=UNIT: unit of a channel without one; may be repeated. SI: each channel whose "
          "quantity the file or its name gives (force, acc1, tip_disp, x, time, ...) is in SI")
      ->allow_extra_args(false);
  command.add_flag("--allow-truncated", arguments.allow_truncated,
                   "Read what is left of a truncated file");
  command.add_option("--rate", arguments.rate,
                     "Sampling rate of a file without times or rate (51.2kHz; Hz without a unit)");
}

RecordingReadOptions read_options(const RecordingArguments& arguments, Progress progress) {
  return {.allow_truncated = arguments.allow_truncated,
          .rate = frequency_of("--rate", arguments.rate),
          .progress = std::move(progress),
          .assumed_units = parse_assumed_units(arguments.assumed_units)};
}

std::optional<double> frequency_guess(const std::string& text) {
  return frequency_of("--frequency", text);
}

void show_warnings(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    print_text(stderr,
               fmt::format("microslip: warning: {}\n", printable(with_option_names(warning.text))));
  }
}

}  // namespace microslip::app
