// SPDX-License-Identifier: MIT

#include <memory>
#include <string>
#include <string_view>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/march.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/load_file.hpp"
#include "microslip/io/model_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "prediction.hpp"
#include "progress_bar.hpp"

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

int run(const MarchArguments& arguments, const Call& call) {
  check_output(arguments.out);
  const ModelFile model = read_model(arguments.model);
  // Without joints the table is one of point motions, as a recording can be.
  check_output(arguments.out, model.structure.joints().empty() ? std::string_view{} : kMarchKind);
  const MarchOptions options = march_options(arguments, model);
  const NormalLoadLaw law =
      arguments.law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental;
  const LoadHistory loads = read_loads(arguments.forces, model.structure, law);
  const MarchResult result =
      march_to_table(arguments.out, model, loads, options, heading_of(call.command_line, model),
                     progress_bar("time", call.quiet));
  return tell_ending(result.summary, true, arguments, call, [&] {
    return describe_march(arguments.model, arguments.forces, model, loads, result);
  });
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
