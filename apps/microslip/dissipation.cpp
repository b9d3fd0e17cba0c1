// SPDX-License-Identifier: MIT
#include "microslip/joint/dissipation.hpp"

#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/csv_writer.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/provenance.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "recording_arguments.hpp"

namespace microslip::app {
namespace {

struct DissipationOptions {
  std::string joint;
  std::string amplitude;
  std::string out;
};

/// D and the loss factor are those of slip and linear damping together, as levels have them.
CsvWriter table_of(const JointFile& file, const std::vector<double>& amplitude) {
  const Joint& joint = file.joint;
  const double beta = identified_damping(file).value_or(0.0);
  std::vector<double> force;
  std::vector<double> energy;
  std::vector<double> secant;
  std::vector<double> loss;
  std::vector<double> linear;
  for (const double a : amplitude) {
    force.push_back(joint.virgin_force(a));
    linear.push_back(beta * a * a);
    energy.push_back(dissipation(joint, a) + linear.back());
    secant.push_back(secant_stiffness(joint, a));
    loss.push_back(loss_factor(joint, a) + beta / (std::numbers::pi * secant.back()));
  }
  CsvWriter table;
  if (beta > 0.0) table.add_comment("linear damping of the joint: " + damping_text(beta));
  table.add_numbers("amplitude", kLength, amplitude);
  table.add_numbers("force", kForce, force);
  table.add_numbers("dissipation", kEnergy, energy);
  table.add_numbers("secant_stiffness", kStiffness, secant);
  table.add_numbers("loss_factor", kDimensionless, loss);
  if (beta > 0.0) table.add_numbers("joint_linear_dissipation", kEnergy, linear);
  return table;
}

int run(const DissipationOptions& options, const Call& call) {
  check_output(options.out, kDissipationKind);
  const std::vector<double> amplitude = parse_range("--amplitude", options.amplitude, kLength);
  if (amplitude.front() < 0.0) {
    throw InputError("--amplitude", amplitude.front(), "FROM must be 0 m or more");
  }
  if (amplitude.front() > 0.0) check_displacement("FROM of --amplitude", amplitude.front());
  check_displacement("TO of --amplitude", amplitude.back());
  const JointFile file = read_joint(options.joint);
  CsvWriter table = table_of(file, amplitude);
  const std::vector<Warning> warnings = reach_warnings(file, amplitude.back());
  add_warnings(warnings, table);
  write_file(options.out, table.str());
  if (!call.quiet) show_warnings(warnings);
  return kDone;
}

}  // namespace

void add_dissipation(CLI::App& program, Call& call) {
  auto options = std::make_shared<DissipationOptions>();
  CLI::App* command = program.add_subcommand(
      "dissipation", "Energy per cycle, secant stiffness and loss factor over the amplitude");
  command->add_option("joint", options->joint, "Joint model, joint.json")
      ->required()
      ->type_name(kJsonValue);
  command
      ->add_option("--amplitude", options->amplitude,
                   "FROM:TO:COUNT[:log], in m or with units; :log for equal ratios")
      ->required();
  command
      ->add_option(
          "--out", options->out,
          "CSV to write: amplitude [m], force [N], dissipation [J], "
          "secant_stiffness [N/m], loss_factor [1], and joint_linear_dissipation [J], the part "
          "of the dissipation that is no slip, where the joint was identified with linear "
          "damping; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_flag("--quiet", call.quiet, "No warnings on the screen; the file has them");
  add_examples(*command,
               {"microslip dissipation joint.json --amplitude 1um:300um:50:log --out curve.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
