// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/predict/rig_model.hpp"

namespace microslip::app {
namespace {

struct ModelOptions {
  std::string rig;
  std::string joint;
  std::string out;
  std::size_t modes = 7;
};

int run(const ModelOptions& options, const Call& call) {
  check_output(options.out, kModelKind);
  const RigModel model =
      model_of_rig(options.rig, options.joint, options.out, options.modes, call.command_line);
  write_file(options.out, model.text);
  if (call.quiet) return kDone;
  show_warnings(model.warnings);
  const bool on_stdout = options.out == "-";
  print_text(on_stdout ? stderr : stdout,
             describe_model(on_stdout ? "standard output" : options.out, model.file.structure) +
                 describe_damping(model.file));
  return kDone;
}

}  // namespace

void add_model(CLI::App& program, Call& call) {
  auto options = std::make_shared<ModelOptions>();
  CLI::App* command = program.add_subcommand(
      "model",
      "Write the structure of a test rig with its joint as a model.toml for frf, backbone, march");
  command->add_option("rig", options->rig, "Description of the test, rig.toml")
      ->required()
      ->type_name(kTomlValue);
  command->add_option("joint", options->joint, "Joint in its contact, joint.json")
      ->required()
      ->type_name(kJsonValue);
  command
      ->add_option("--out", options->out,
                   "Model to write, model.toml: modes, points named after the channels, the joint; "
                   "- is standard output")
      ->required()
      ->type_name(kTomlValue);
  command->add_option("--modes", options->modes, "Modes of the beam in the model")
      ->check(CLI::Range(1, 40))
      ->capture_default_str();
  command->add_flag("--quiet", call.quiet, "No summary, no warnings");
  add_examples(*command,
               {"microslip model rig.toml joint.json --out model.toml",
                "microslip frf model.toml --response 0.1mm --frequency 53:58 --out frf.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
