// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/workflow/measure/measurement_run.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct MeasureOptions : MeasurementRun {
  std::string seed_text = "1";
};

int run(MeasureOptions options, const Call& call) {
  options.seed = parse_whole_number("--seed", options.seed_text, 0, UINT64_MAX);
  options.command = call.command_line;
  options.solving = progress_bar("levels", call.quiet);
  options.writing = progress_bar("writing", call.quiet);
  const FinishedMeasurement done = run_measurement(options);
  if (!call.quiet) {
    show_warnings(done.warnings);
    print_text(stdout, describe_measurement(options, done));
  }
  if (done.test.summary.converged()) return kDone;
  print_text(stderr, fmt::format("microslip: {}\n", done.test.summary.reason));
  return kNotConverged;
}

}  // namespace

void add_measure(CLI::App& program, Call& call) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = program.add_subcommand(
      "measure",
      "Virtual test of a rig with a known joint: records at all levels, and the exact results");
  command
      ->add_option("rig", options->rig,
                   "Description of the test, rig.toml, with [test] and the true joint in [contact]")
      ->required()
      ->type_name(kTomlValue);
  command->add_option("--out", options->out, "Folder to write to; created if missing")
      ->required()
      ->type_name(kFolderValue);
  command->add_option("--format", options->format, "Format of the records; uff is binary")
      ->check(CLI::IsMember({"csv", "uff", "uff-ascii", "mat", "h5"}))
      ->capture_default_str();
  command->add_option("--seed", options->seed_text, "Seed of the noise and of the phases")
      ->capture_default_str();
  auto* no_shaker = command->add_flag("--no-shaker", options->no_shaker,
                                      "Drive with a pure force, without shaker and force control");
  command
      ->add_flag("--before-control", options->before_control,
                 "Also write the records under a sinusoidal voltage: before_control_…")
      ->excludes(no_shaker);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip measure rig.toml --out test",
                          "microslip measure rig.toml --out test --format h5 --seed 2",
                          "microslip reduce test/rig.toml test/level_*.csv --out levels.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
