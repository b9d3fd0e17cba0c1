// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/ringdown_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/reduce/decay_reduction.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"

namespace microslip::app {
namespace {

int run_of_modes(const RingdownArguments& arguments, const Call& call) {
  check_output(arguments.out, kModalLevelsKind);
  ModalDecayReduction options = modal_decay_options(arguments);
  options.reading.progress = progress_bar("reading", call.quiet);
  options.progress = progress_bar("modes", call.quiet);
  const ReducedModalDecay reduced = reduce_modal_decay(options);
  write_file(arguments.out, modal_levels_text(reduced, call.command_line));
  if (!call.quiet) {
    print_text(arguments.out == "-" ? stderr : stdout,
               with_option_names(describe_modal_decay(reduced)));
  }
  return reduced.converged() ? kDone : kNotConverged;
}

int run(const RingdownArguments& arguments, const Call& call) {
  if (is_modal(arguments)) return run_of_modes(arguments, call);
  check_output(arguments.out, arguments.modal_mass.empty() ? kDampingLevelsKind : kLevelsKind);
  DecayReduction options = decay_options(arguments);
  options.reading.progress = progress_bar("reading", call.quiet);
  const ReducedDecay reduced = reduce_decay(options);
  if (reduced.levels.amplitude.empty()) {
    throw InputError("--loss-factor", options.levels->loss_factor,
                     "must leave some loss to the joint, but exceeds all measured losses");
  }
  write_file(arguments.out, levels_text(reduced, call.command_line));
  if (!call.quiet) {
    print_text(arguments.out == "-" ? stderr : stdout, with_option_names(describe_decay(reduced)));
  }
  return reduced.decay.summary.converged() ? kDone : kNotConverged;
}

}  // namespace

void add_ringdown(CLI::App& program, Call& call) {
  auto options = std::make_shared<RingdownArguments>();
  CLI::App* command =
      program.add_subcommand("ringdown", "Levels of amplitude and dissipation from one free decay");
  command
      ->add_option("recording", options->recording,
                   "Recording of a free decay, evenly sampled: time [s], acc1 [m/s^2], ...")
      ->required()
      ->type_name(kRecordingValue);
  command
      ->add_option(
          "--out", options->out,
          "Levels to write as CSV: amplitude [m], dissipation [J], frequency [Hz], "
          "damping_ratio [1], each with its standard deviation (_std), decay_time [s], source, "
          "flags; no dissipation without --modal-mass. With --mode or --model modal levels: mode "
          "[1], displacement [m], frequency [Hz], damping_ratio [1], ...; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  add_ringdown_arguments(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip ringdown decay.csv --modal-mass 1.2 --out levels.csv",
                "microslip ringdown decay.csv --channel acc1 --frequency 50 --band 40:65 \\",
                "          --modal-mass 1.2 --joint-ratio 0.3 --loss-factor 0.001 \\",
                "          --out levels.csv", "microslip ringdown decay.csv --out damping.csv",
                "microslip ringdown decay.csv --channel acc1 --mode 1 --out modal_levels.csv",
                "microslip ringdown blow.csv --model model.toml --sensor acc1=drive \\",
                "          --sensor acc2=p2 --out modal_levels.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
