// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/modes/structure_model.hpp"

namespace microslip::app {
namespace {

struct ModesArguments {
  std::string structure;
  std::string out;
};

int run(const ModesArguments& options, const Call& call) {
  check_output(options.out, kModelKind);
  const StructureModel model = model_of_structure(options.structure, options.out, call.command_line,
                                                  progress_bar("solutions", call.quiet));
  write_file(options.out, model.text);
  const ExitStatus status = model.modes.summary.converged() ? kDone : kNotConverged;
  if (call.quiet) return status;
  show_warnings(model.modes.warnings);
  print_text(options.out == "-" ? stderr : stdout,
             describe_structure_model(options.structure, model));
  return status;
}

}  // namespace

void add_modes(CLI::App& program, Call& call) {
  auto options = std::make_shared<ModesArguments>();
  CLI::App* command =
      program.add_subcommand("modes",
                             "Make a model.toml from the mass and stiffness matrices of a "
                             "structure, or its measured modes, and its joints");
  command
      ->add_option("structure", options->structure,
                   "Matrices, or a test (universal files 55, 58, 2414; responses in CSV, MATLAB "
                   "and HDF5 files), "
                   "supports, points, joints and the modes wanted, STRUCTURE.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("--out", options->out,
                   "Model to write, model.toml: modes, static attachments (not of a test), points, "
                   "joints; - is standard output")
      ->required()
      ->type_name(kTomlValue);
  command->add_flag("--quiet", call.quiet, "No summary, no warnings, no progress");
  add_examples(*command,
               {"microslip modes structure.toml --out model.toml",
                "microslip backbone model.toml --response 1um:1mm:40:log --out backbone.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
