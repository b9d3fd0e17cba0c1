// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct DissipationOptions {
  std::string joint;
  std::string amplitude;
  std::string out;
  JointDrawArguments draws;
};

int run(const DissipationOptions& options, const Call& call) {
  check_output(options.out, kDissipationKind);
  const std::vector<double> amplitude = parse_range("--amplitude", options.amplitude, kLength);
  if (amplitude.front() < 0.0) {
    throw InputError("--amplitude", amplitude.front(), "FROM must be 0 m or more");
  }
  if (amplitude.front() > 0.0) check_displacement("FROM of --amplitude", amplitude.front());
  check_displacement("TO of --amplitude", amplitude.back());
  const JointFile file = read_joint(options.joint);
  const JointTable table = dissipation_of(file, amplitude, command_of(call, options.out),
                                          draws_of(file, options.draws, call.quiet));
  write_file(options.out, table.text);
  if (!call.quiet) show_warnings(table.warnings);
  return table.taken && table.taken->too_many_failed() ? kNotConverged : kDone;
}

}  // namespace

void add_dissipation(CLI::App& program, Call& call) {
  auto options = std::make_shared<DissipationOptions>();
  CLI::App* command = program.add_subcommand(
      "dissipation", "Energy per cycle, secant stiffness and loss factor over amplitude");
  command->add_option("joint", options->joint, "Joint model, joint.json")
      ->required()
      ->type_name(kJsonValue);
  command
      ->add_option("--amplitude", options->amplitude,
                   "FROM:TO:COUNT[:log], in m or with units; :log for equal ratios")
      ->required();
  command
      ->add_option("--out", options->out,
                   "CSV to write: amplitude [m], force [N], dissipation [J], "
                   "secant_stiffness [N/m], loss_factor [1], and joint_linear_dissipation [J], the "
                   "part of the dissipation not due to slip, if the joint was identified with "
                   "linear damping; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  add_joint_draw_arguments(*command, options->draws,
                           "force_lower and force_upper [N], and those of the other columns");
  command->add_flag("--quiet", call.quiet, "No warnings on the screen; the file contains them");
  add_examples(*command,
               {"microslip dissipation joint.json --amplitude 1um:300um:50:log --out curve.csv",
                "microslip dissipation joint.json --amplitude 1um:300um:50:log --draws 1000 \\",
                "          --samples joint_samples.h5 --out curve.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
