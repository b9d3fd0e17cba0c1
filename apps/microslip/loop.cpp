// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/path_file.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/provenance.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "recording_arguments.hpp"

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
};

/// First loading to A, then one steady cycle: A to −A and back.
std::vector<double> cycle(double amplitude, std::size_t points) {
  std::vector<double> x;
  x.reserve(3 * points + 1);
  const auto branch = [&](double from, double to) {
    for (std::size_t i = 1; i <= points; ++i) {
      x.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(points));
    }
  };
  x.push_back(0.0);
  branch(0.0, amplitude);
  branch(amplitude, -amplitude);
  branch(-amplitude, amplitude);
  return x;
}

DisplacementPath path_of(const LoopOptions& options) {
  if (!options.path.empty()) return read_path(options.path);
  const double amplitude = parse_quantity("--amplitude", options.amplitude, kLength);
  check_displacement("--amplitude", amplitude);
  return {cycle(amplitude, options.points), {}};
}

/// Constant normal load has an exact memory; a varying one needs elements that are marched.
std::vector<double> forces(const Joint& joint, const DisplacementPath& path,
                           const LoopOptions& options) {
  std::vector<double> force(path.displacement.size());
  if (path.normal_load.empty()) {
    Memory(joint).march(path.displacement, force);
    return force;
  }
  const JenkinsNetwork network = JenkinsNetwork::discretise(joint, options.elements);
  const NormalLoadLaw law =
      options.law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental;
  NetworkMemory(network, law).march(path.displacement, path.normal_load, force);
  return force;
}

/// Sliders slip that lie below k times the farthest displacement, as in a cycle of that amplitude.
double farthest(const DisplacementPath& path) {
  double result = 0.0;
  for (const double x : path.displacement) result = std::max(result, std::abs(x));
  return result;
}

/// A loss of βA² whatever the frequency is known for harmonics alone.
std::optional<Warning> damping_warning(const JointFile& file) {
  const double beta = identified_damping(file).value_or(0.0);
  if (beta == 0.0) return std::nullopt;
  return Warning{
      "linear_damping_left_out",
      fmt::format("The joint was identified with a linear damping of {}, which is not in "
                  "the force: a loss that grows with the square of the amplitude and does "
                  "not depend on the rate has no force along a path. Per cycle of "
                  "amplitude A the joint loses {:.6g} J/m^2 A^2 more than the area of "
                  "the loop.",
                  damping_text(beta), beta)};
}

int run(const LoopOptions& options, const Call& call) {
  check_output(options.out, kLoopKind);
  const JointFile file = read_joint(options.joint);
  const DisplacementPath path = path_of(options);
  CsvWriter table = loop_table(path, forces(file.joint, path, options));
  std::vector<Warning> warnings = reach_warnings(file, farthest(path));
  if (const auto warning = damping_warning(file)) warnings.push_back(*warning);
  add_warnings(warnings, table);
  write_file(options.out, table.str());
  if (!call.quiet) show_warnings(warnings);
  return kDone;
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
      "Path as CSV: displacement [m], and normal_load [1] where the normal load varies");
  path->type_name(kCsvValue);
  CLI::Option* amplitude =
      command->add_option("--amplitude", options->amplitude,
                          "First loading and one cycle of this amplitude, in m or with a unit");
  path->excludes(amplitude);
  command
      ->add_option("--normal-load-law", options->law,
                   "What a stuck element does when its normal load varies")
      ->check(CLI::IsMember({"incremental", "total"}))
      ->capture_default_str();
  command->add_option("--points", options->points, "Points a branch, with --amplitude")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command
      ->add_option("--elements", options->elements,
                   "Jenkins elements, where the normal load varies")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--out", options->out, "CSV to write; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_flag("--quiet", call.quiet, "No warnings on the screen; the file has them");
  add_examples(*command, {"microslip loop joint.json --amplitude 300um --out loop.csv",
                          "microslip loop joint.json --path path.csv --out -"});
  command->callback([options, &call] {
    if (options->path.empty() && options->amplitude.empty()) {
      throw CLI::RequiredError("--path or --amplitude");
    }
    call.run = [options, &call] { return run(*options, call); };
  });
}

}  // namespace microslip::app
