// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/reduce/modal_levels_reduction.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"
#include "microslip/workflow/reduce/reduction_text.hpp"

namespace microslip::app {
namespace {

struct ReduceOptions : ReductionInputs {
  ReductionOptions reduction;
  std::string force;
  std::vector<std::string> sensors;
  std::size_t mode = 0;
  std::string out;
  std::string frequency;
  std::size_t order = 10;
  bool no_vibrometer = false;
  RecordingArguments arguments;
};

void refuse(std::string_view option, std::string_view value, std::string_view of_what) {
  throw InputError(option, value, fmt::format("must not be given {}", of_what));
}

/// Options that only one of the two descriptions of a test has a use for.
void check_use(const ReduceOptions& options, bool is_model) {
  if (is_model) {
    const std::string_view with = "with a model.toml, which has its own modes and no vibrometer";
    if (options.reduction.modes > 0) {
      refuse("--modes", std::to_string(options.reduction.modes), with);
    }
    if (options.no_vibrometer) refuse("--no-vibrometer", "given", with);
    return;
  }
  const std::string_view with = "with a rig.toml, which names its channels";
  if (!options.sensors.empty()) refuse("--sensor", options.sensors.front(), with);
  if (!options.force.empty()) refuse("--force", options.force, with);
  if (options.mode > 0) refuse("--mode", std::to_string(options.mode), with);
}

int run_of_model(const ReduceOptions& options, const Call& call) {
  check_output(options.out, kModalLevelsKind);
  ModalLevelsReduction reduction{.force = options.force, .sensors = options.sensors};
  reduction.reduction.fit = options.reduction.fit;
  if (options.mode > 0) reduction.reduction.mode = options.mode;
  const ReducedModalLevels reduced = reduce_modal_levels(options, reduction);
  if (!call.quiet) std::ranges::for_each(reduced.warnings, show_warnings);
  write_file(options.out, modal_levels_text(reduced, call.command_line));
  if (!call.quiet) {
    print_text(options.out == "-" ? stderr : stdout, describe_modal_levels(reduced));
  }
  return kDone;
}

int run(ReduceOptions options, const Call& call) {
  options.reduction.fit.order = static_cast<int>(options.order);
  options.reduction.use_vibrometer = !options.no_vibrometer;
  options.reduction.fit.frequency_guess = frequency_guess(options.frequency);
  options.reading = read_options(options.arguments);
  options.progress = progress_bar("records", call.quiet);
  // A pipe can be read only once: it is taken as a rig.
  const bool is_model =
      options.test != "-" && file_kind(read_kind_head(options.test)) == kModelKind;
  check_use(options, is_model);
  if (is_model) return run_of_model(options, call);
  check_output(options.out, kLevelsKind);
  const ReducedRecordings reduced = reduce_recordings(options, options.reduction);
  if (!call.quiet) std::ranges::for_each(reduced.warnings, show_warnings);
  write_file(options.out, levels_text(reduced, call.command_line));
  if (!call.quiet) {
    print_text(options.out == "-" ? stderr : stdout,
               describe_reduction(reduced.reducer, reduced.batch));
  }
  return kDone;
}

void add_files(CLI::App& command, ReduceOptions& options) {
  command
      .add_option("rig", options.test,
                  "Description of the test, rig.toml; or a structure with joints, model.toml, "
                  "detected from its schema: then modal levels with amplitude and dissipation of "
                  "each joint are written")
      ->required()
      ->type_name(kTomlValue);
  command
      .add_option(
          "recordings", options.recordings,
          "Steady records, one per level (CSV, UFF, MAT, HDF5), or stepped-sine tables: CSV "
          "with frequency [Hz], force [N], acceleration [m/s^2], phase [rad], or "
          "FILE.mat:VARIABLE with such fields; or frequency responses with the level of the "
          "response (UFF, FILE.mat:VARIABLE)")
      ->required()
      ->type_name(kRecordingValue);
  command
      .add_option("--out", options.out,
                  "levels.csv to write, or modal_levels.csv of a model; - is standard output")
      ->required()
      ->type_name(kCsvValue);
}

void add_methods(CLI::App& command, ReduceOptions& options) {
  command.add_option("--frequency", options.frequency,
                     "Drive frequency, to within 3 %, in Hz; default: detected");
  command.add_option("--order", options.order, "Number of harmonics fitted")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command
      .add_option("--modes", options.reduction.modes,
                  "Modes of the beam [default: those of the rig's [test], or 30]")
      ->check(CLI::Range(1, 200));
  command.add_flag("--no-vibrometer", options.no_vibrometer,
                   "Joint displacement from the accelerometers even if there is a vibrometer");
  command
      .add_option("--sensor", options.sensors,
                  "CHANNEL=POINT: the accelerometer of a channel is at that point of the model; "
                  "may be repeated; replaces [[accelerometer]] of model.toml. At least as many as "
                  "joints, at points that the joints move")
      ->allow_extra_args(false);
  command.add_option("--force", options.force,
                     "With a model: channel of the force; default: that of its [excitation], or "
                     "the only force channel");
  command
      .add_option("--mode", options.mode,
                  "Mode of the model, from 1; default: the one whose frequency with stuck joints "
                  "is nearest to that of the record")
      ->check(CLI::Range(1, 100000));
}

}  // namespace

void add_reduce(CLI::App& program, Call& call) {
  auto options = std::make_shared<ReduceOptions>();
  CLI::App* command =
      program.add_subcommand("reduce",
                             "Levels from steady recordings: of a frictional-support test, or of "
                             "the modes of a structure with several joints");
  add_files(*command, *options);
  add_methods(*command, *options);
  add_recording_arguments(*command, options->arguments);
  command->add_flag("--skip-faulty", options->skip_faulty,
                    "Leave out, and list, what cannot be read or reduced");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip reduce rig.toml level_*.csv --out levels.csv",
                          "microslip reduce rig.toml test.h5 --no-vibrometer --out levels.csv",
                          "microslip reduce modes.toml sweep.csv --out levels.csv",
                          "microslip reduce model.toml mode1_*.csv --sensor acc1=drive \\",
                          "          --sensor acc2=p2 --out modal_levels.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
