// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/damping_twice.hpp"
#include "microslip/dynamics/march.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/load_file.hpp"
#include "microslip/io/march_file.hpp"
#include "microslip/io/model_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "prediction.hpp"
#include "progress_bar.hpp"
#include "report_text.hpp"

namespace microslip::app {
namespace {

constexpr std::uint64_t kMostEvery = 1'000'000'000;
constexpr std::uint64_t kMostElements = 1'000'000;

struct MarchArguments : ModelArguments {
  std::string forces;
  std::string step;
  std::string every = "1";
  std::string law = "incremental";
  std::string elements = "1000";
  bool no_error_estimate = false;
};

MarchOptions march_options(const MarchArguments& arguments, const ModelFile& model) {
  MarchOptions options;
  options.points = {model.response};
  options.every = parse_whole_number("--every", arguments.every, 1, kMostEvery);
  options.estimate_error = !arguments.no_error_estimate;
  options.elements = parse_whole_number("--elements", arguments.elements, 1, kMostElements);
  if (arguments.step.empty()) return options;
  options.step = parse_quantity("--step", arguments.step, kTime);
  if (!(options.step > 0.0)) throw InputError("--step", options.step, "must be above 0 s");
  return options;
}

std::string describe_energy(const MarchEnergy& energy) {
  std::string text = line("input", fmt::format("{:.5g} J", energy.input));
  text += line("linear dissipation", fmt::format("{:.5g} J", energy.linear_dissipation));
  for (const JointEnergy& joint : energy.joints) {
    std::string lost = fmt::format("{:.5g} J dissipated", joint.dissipation);
    if (joint.linear_dissipation > 0.0) {
      lost += fmt::format(" by slip, {:.5g} J by linear damping", joint.linear_dissipation);
    }
    text += line(joint.joint, fmt::format("{}, {:.5g} J stored at the end", lost, joint.stored));
  }
  text += line("at the end",
               fmt::format("{:.5g} J kinetic, {:.5g} J elastic", energy.kinetic, energy.elastic));
  return text + line("energy imbalance", fmt::format("{:.2g}", energy.imbalance()));
}

std::string describe(const MarchArguments& arguments, const ModelFile& model,
                     const LoadHistory& loads, const MarchResult& result) {
  std::string text = fmt::format("March from {:g} to {:g} s\n", loads.time.front(), result.reached);
  text += describe_model(arguments.model, model.structure);
  text +=
      line("loads", fmt::format("{}, {} times", input_name(arguments.forces), loads.time.size()));
  text += line("method", result.summary.method);
  text += describe_ending(result.summary);
  text += line("steps", fmt::format("{}, {} reversals of joints, {} loops closed or slips begun",
                                    result.steps, result.reversals, result.kinks));
  const LargestMotion& largest = result.largest.front();
  text += line("largest response",
               fmt::format("{:.5g} m, {:.5g} m/s, {:.5g} m/s^2 at '{}'", largest.displacement,
                           largest.velocity, largest.acceleration, model.response));
  text += describe_energy(result.energy);
  if (result.error_estimate) {
    text += line("estimated error",
                 fmt::format("{:.2g} of the largest displacement", *result.error_estimate));
  }
  return text + describe_damping(model) + describe_warnings(result.warnings);
}

int run(const MarchArguments& arguments, const Call& call) {
  check_output(arguments.out);
  const ModelFile model = read_model(arguments.model);
  // Without joints the table is one of point motions, as a recording can be.
  check_output(arguments.out, model.structure.joints().empty() ? std::string_view{} : kMarchKind);
  const MarchOptions options = march_options(arguments, model);
  const NormalLoadLaw law =
      arguments.law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental;
  const LoadHistory loads = read_loads(arguments.forces, model.structure, law);
  MarchTable table(arguments.out, model.structure, loads, heading_of(call, model));
  const auto write = [&](const MarchRow& row) { table.add(row); };
  MarchResult result =
      march_rows(model.structure, loads, options, write, progress_bar("time", call.quiet));
  std::ranges::move(damping_twice(model.structure), std::back_inserter(result.warnings));
  std::ranges::move(reach_warnings(model, result.reach), std::back_inserter(result.warnings));
  table.finish(result);
  return tell_ending(result.summary, true, arguments, call,
                     [&] { return describe(arguments, model, loads, result); });
}

}  // namespace

void add_march(CLI::App& program, Call& call) {
  auto arguments = std::make_shared<MarchArguments>();
  CLI::App* command =
      program.add_subcommand("march", "Motion in time of a structure with joints under any force");
  command->add_option("model", arguments->model, "Structure with joints, model.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("--force-file", arguments->forces,
                   "What acts, as CSV: time [s], force [N] at the excitation of the model or force "
                   "at POINT [N]; normal_load [1] or normal_load of JOINT [1] where the normal "
                   "load of a joint varies. Linear between the times; - is standard input")
      ->required()
      ->type_name(kCsvValue);
  command
      ->add_option("--out", arguments->out,
                   "CSV to write: time [s], force [N], displacement [m], velocity [m/s], "
                   "acceleration [m/s^2], JOINT displacement [m], JOINT force [N]; - is standard "
                   "output")
      ->required()
      ->type_name(kCsvValue);
  command->add_option("--step", arguments->step,
                      "Longest step, in s or with a unit; without it a twentieth of the shortest "
                      "period of the stuck structure, an eightieth where a density has more than "
                      "16 atoms, a four-hundredth where a normal load varies");
  command->add_flag("--no-error-estimate", arguments->no_error_estimate,
                    "Do not march a second time with twice the step to tell the error: a third of "
                    "the time less");
  command
      ->add_option("--every", arguments->every, "Times of the force file per row that is written")
      ->capture_default_str();
  command
      ->add_option("--normal-load-law", arguments->law,
                   "What a stuck element does when its normal load varies")
      ->check(CLI::IsMember({"incremental", "total"}))
      ->capture_default_str();
  command
      ->add_option("--elements", arguments->elements,
                   "Jenkins elements of a joint whose normal load varies")
      ->capture_default_str();
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(
      *command,
      {"microslip march model.toml --force-file force.csv --out march.csv",
       "microslip march model.toml --force-file force.csv --step 20ms --every 10 --out -",
       "microslip march model.toml --force-file force.csv --no-error-estimate --out march.csv"});
  command->callback(
      [arguments, &call] { call.run = [arguments, &call] { return run(*arguments, call); }; });
}

}  // namespace microslip::app
