// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/workflow/recordings_reduction.hpp"
#include "microslip/workflow/reduction_text.hpp"
#include "progress_bar.hpp"
#include "recording_arguments.hpp"

namespace microslip::app {
namespace {

struct ReduceOptions : RecordingsReduction {
  std::string out;
  std::string frequency;
  std::size_t order = 10;
  bool no_vibrometer = false;
  RecordingArguments arguments;
};

int run(ReduceOptions options, const Call& call) {
  check_output(options.out, kLevelsKind);
  options.reduction.fit.order = static_cast<int>(options.order);
  options.reduction.use_vibrometer = !options.no_vibrometer;
  options.reduction.fit.frequency_guess = frequency_guess(options.frequency);
  options.reading = read_options(options.arguments);
  options.progress = progress_bar("records", call.quiet);
  const ReducedRecordings reduced = reduce_recordings(options);
  if (!call.quiet) std::ranges::for_each(reduced.warnings, show_warnings);
  write_file(options.out, levels_text(reduced, call.command_line));
  if (!call.quiet) {
    fmt::print(options.out == "-" ? stderr : stdout, "{}",
               describe_reduction(reduced.reducer, reduced.batch));
  }
  return kDone;
}

}  // namespace

void add_reduce(CLI::App& program, Call& call) {
  auto options = std::make_shared<ReduceOptions>();
  CLI::App* command =
      program.add_subcommand("reduce", "Levels of a frictional-support test from its recordings");
  command->add_option("rig", options->rig, "Description of the test, rig.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("recordings", options->recordings,
                   "Steady records, one a level (CSV, UFF, MAT, HDF5), or stepped-sine tables: CSV "
                   "with frequency [Hz], force [N], acceleration [m/s^2], phase [rad], or "
                   "FILE.mat:VARIABLE with such fields")
      ->required()
      ->type_name(kRecordingValue);
  command->add_option("--out", options->out, "levels.csv to write; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_option("--frequency", options->frequency,
                      "Frequency of the drive, to 3 %, in Hz; found if it is not given");
  command->add_option("--order", options->order, "Harmonics that are fitted")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command
      ->add_option("--modes", options->reduction.modes,
                   "Modes of the beam [default: those of the rig's [test], or 30]")
      ->check(CLI::Range(1, 200));
  command->add_flag("--no-vibrometer", options->no_vibrometer,
                    "Joint displacement from the accelerometers even if there is a vibrometer");
  add_recording_arguments(*command, options->arguments);
  command->add_flag("--skip-faulty", options->skip_faulty,
                    "Leave out what cannot be read or reduced, and say so");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip reduce rig.toml level_*.csv --out levels.csv",
                          "microslip reduce rig.toml test.h5 --no-vibrometer --out levels.csv",
                          "microslip reduce modes.toml sweep.csv --out levels.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
