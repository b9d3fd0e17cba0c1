// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/path_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct LoopOptions {
  std::string joint;
  std::string path;
  std::string amplitude;
  std::string law = "incremental";
  std::string out;
  std::size_t points = 200;
  std::size_t elements = 1000;
  JointDrawArguments draws;
};

DisplacementPath path_of(const LoopOptions& options) {
  if (!options.path.empty()) return read_path(options.path);
  const double amplitude = parse_quantity("--amplitude", options.amplitude, kLength);
  check_displacement("--amplitude", amplitude);
  return {loading_and_cycle(amplitude, options.points), {}};
}

int run(const LoopOptions& options, const Call& call) {
  check_output(options.out, kLoopKind);
  const JointFile file = read_joint(options.joint);
  const DisplacementPath path = path_of(options);
  const NormalLoadLaw law =
      options.law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental;
  const JointTable table = loop_of(file, path, law, options.elements, command_of(call, options.out),
                                   draws_of(file, options.draws, call.quiet));
  write_file(options.out, table.text);
  if (!call.quiet) show_warnings(table.warnings);
  return table.taken && table.taken->too_many_failed() ? kNotConverged : kDone;
}

}  // namespace

void add_loop(CLI::App& program, Call& call) {
  auto options = std::make_shared<LoopOptions>();
  CLI::App* command = program.add_subcommand(
      "loop", "Force of a joint along a displacement path, or around one steady cycle");
  command->add_option("joint", options->joint, "Joint model, joint.json")
      ->required()
      ->type_name(kJsonValue);
  CLI::Option* path = command->add_option(
      "--path", options->path,
      "Path as CSV: displacement [m], and normal_load [1] if the normal load varies");
  path->type_name(kCsvValue);
  CLI::Option* amplitude =
      command->add_option("--amplitude", options->amplitude,
                          "Initial loading and one cycle of this amplitude, in m or with a unit");
  path->excludes(amplitude);
  command
      ->add_option("--normal-load-law", options->law,
                   "Behaviour of a stuck element when its normal load varies")
      ->check(CLI::IsMember({"incremental", "total"}))
      ->capture_default_str();
  command->add_option("--points", options->points, "Points per branch, with --amplitude")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command
      ->add_option("--elements", options->elements,
                   "Number of Jenkins elements if the normal load varies")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--out", options->out, "CSV to write; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  add_joint_draw_arguments(*command, options->draws, "lower and upper, of the force [N]");
  command->add_flag("--quiet", call.quiet, "No warnings on the screen; the file contains them");
  add_examples(*command, {"microslip loop joint.json --amplitude 300um --out loop.csv",
                          "microslip loop joint.json --path path.csv --out -",
                          "microslip loop joint.json --amplitude 300um --draws 1000 \\",
                          "          --samples joint_samples.h5 --out loop.csv"});
  command->callback([options, &call] {
    if (options->path.empty() && options->amplitude.empty()) {
      throw CLI::RequiredError("--path or --amplitude");
    }
    call.run = [options, &call] { return run(*options, call); };
  });
}

}  // namespace microslip::app
