// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/reduce/record_levels.hpp"

namespace microslip::app {
namespace {

struct LevelsArguments {
  RecordLevelsOptions options;
  std::string out;
  RecordingArguments reading;
};

int run(const LevelsArguments& arguments, const Call& call) {
  check_output(arguments.out, kLevelsKind);
  RecordLevelsOptions options = arguments.options;
  options.reading = read_options(arguments.reading, progress_bar("reading", call.quiet));
  const RecordLevels found = find_record_levels(options);
  write_file(arguments.out, levels_text(found, call.command_line));
  if (!call.quiet) {
    print_text(arguments.out == "-" ? stderr : stdout,
               with_option_names(describe_record_levels(found)));
  }
  return kDone;
}

}  // namespace

void add_levels(CLI::App& program, Call& call) {
  auto arguments = std::make_shared<LevelsArguments>();
  CLI::App* command = program.add_subcommand(
      "levels", "Levels of the closed cycles of force-displacement records of a joint");
  command
      ->add_option("records", arguments->options.records,
                   "Recordings of force and displacement of one joint over time: "
                   "loops of any waveform, or random motion")
      ->required()
      ->type_name(kRecordingValue);
  command
      ->add_option("--out", arguments->out,
                   "Levels to write as CSV, one row per closed cycle: amplitude [m], dissipation "
                   "[J], secant_stiffness [N/m], their standard deviations (_std) if there is "
                   "noise, source, start_time [s], end_time [s], flags; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_option("--force", arguments->options.channels.force,
                      "Channel of the force; not needed if there is only one");
  command->add_option("--displacement", arguments->options.channels.displacement,
                      "Channel of the displacement; not needed if there is only one");
  add_recording_arguments(*command, arguments->reading);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip levels loops.csv --out levels.csv",
                "microslip levels test_*.mat --force load --displacement gap \\",
                "          --out levels.csv", "microslip levels loops.csv --out levels.csv &&",
                "          microslip identify levels.csv --stiffness 1.7e5 --out "
                "joint.json"});
  command->callback(
      [arguments, &call] { call.run = [arguments, &call] { return run(*arguments, call); }; });
}

}  // namespace microslip::app
