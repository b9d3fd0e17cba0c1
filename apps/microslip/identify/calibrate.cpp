// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/workflow/identify/calibration.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct CalibrateArguments {
  ModelCalibration calibration;
  std::string frequency = "change";
  std::string stiffness = "given";
  std::string model_frequencies = "given";
  std::string shapes = "found";
  std::string edges = "sought";
  std::string forcing = "excitation";
  std::string harmonics = "5";
  std::string samples = "1000";
  std::string seed = "1";
};

FrequencyUse frequency_use(const std::string& text) {
  if (text == "absolute") return FrequencyUse::kAbsolute;
  return text == "ignore" ? FrequencyUse::kIgnore : FrequencyUse::kChange;
}

CalibrationOptions library_options(const CalibrateArguments& arguments, bool quiet) {
  constexpr std::uint64_t kFewestDraws = 100;
  constexpr std::uint64_t kMostDraws = 100'000;  // more memory than use
  constexpr std::uint64_t kMostHarmonics = 100;
  CalibrationOptions options;
  options.frequency = frequency_use(arguments.frequency);
  options.fit_stiffness = arguments.stiffness == "fit";
  options.stuck_shapes = arguments.shapes == "stuck";
  options.edges = arguments.edges == "sought";
  options.balance.forcing = arguments.forcing == "modal" ? Forcing::kModal : Forcing::kExcitation;
  options.balance.harmonics =
      parse_whole_number("--harmonics", arguments.harmonics, 1, kMostHarmonics);
  options.draws = parse_whole_number("--samples", arguments.samples, kFewestDraws, kMostDraws);
  options.seed =
      parse_whole_number("--seed", arguments.seed, 0, std::numeric_limits<std::uint64_t>::max());
  options.progress = progress_bar("calibrating", quiet);
  return options;
}

void check_planned(const std::vector<ResultFile>& files) {
  std::vector<PlannedOutput> outputs;
  outputs.reserve(files.size());
  for (const ResultFile& file : files) outputs.push_back({file.path, file.kind});
  check_outputs(outputs);
}

int run(const CalibrateArguments& arguments, const Call& call) {
  ModelCalibration calibration = arguments.calibration;
  calibration.options = library_options(arguments, call.quiet);
  calibration.options.check();
  if (arguments.model_frequencies == "corrected") {
    calibration.model_frequencies = ModelFrequencies::kCorrected;
  }
  calibration.command = call.command_line;
  const std::vector<ResultFile> planned = planned_files(calibration);
  OutputFolders folders;
  folders.make(calibration.out);
  check_planned(planned);
  const CalibratedModel done = calibrate_model(calibration);
  OutputFiles outputs;
  for (const ResultFile& file : done.files) outputs.add(file.path, file.content);
  outputs.commit();
  if (!call.quiet) print_text(stdout, describe_calibration(calibration, done));
  return done.found.summary.converged() ? kDone : kNotConverged;
}

void add_method_options(CLI::App& command, CalibrateArguments& arguments) {
  command
      .add_option(
          "--frequency", arguments.frequency,
          "Use of the frequencies of the levels. change: their change over the levels of each "
          "mode, as the model may have an offset; absolute: their values; ignore: not used")
      ->check(CLI::IsMember({"change", "absolute", "ignore"}))
      ->capture_default_str();
  command
      .add_option("--stiffness", arguments.stiffness,
                  "Stiffness of the joints to be identified. given: stiffness_N_per_m of the "
                  "model; fit: identified too, needs --frequency absolute")
      ->check(CLI::IsMember({"given", "fit"}))
      ->capture_default_str();
  command
      .add_option("--model-frequencies", arguments.model_frequencies,
                  "Frequencies of the modes in model.toml. given: as in the model, with the "
                  "offsets that the levels show as frequency_std; corrected: with these offsets, "
                  "and what is left as frequency_std")
      ->check(CLI::IsMember({"given", "corrected"}))
      ->capture_default_str();
  command
      .add_option(
          "--shapes", arguments.shapes,
          "Joint displacements that are not measured. found: of the model with the identified "
          "joints; stuck: of the stuck structure, wrong where joints slip, for comparison")
      ->check(CLI::IsMember({"found", "stuck"}))
      ->capture_default_str();
  command
      .add_option("--edges", arguments.edges,
                  "sought: jumps of the density of a joint at slip forces that the levels make "
                  "very likely (20 levels for each joint are needed); none: no jumps")
      ->check(CLI::IsMember({"sought", "none"}))
      ->capture_default_str();
  command
      .add_option("--forcing", arguments.forcing,
                  "Excitation of the levels. excitation: that of the model, at phase resonance; "
                  "modal: none, as in a free decay")
      ->check(CLI::IsMember({"excitation", "modal"}))
      ->capture_default_str();
  command.add_option("--harmonics", arguments.harmonics, "Harmonics of the vibrations")
      ->type_name("UINT")
      ->capture_default_str();
  command
      .add_option("--samples", arguments.samples,
                  "Posterior draws: their mean is the result, their spread gives the bands")
      ->type_name("UINT")
      ->capture_default_str();
  command.add_option("--seed", arguments.seed, "Seed of the draws")
      ->type_name("UINT")
      ->capture_default_str();
  command.add_flag("--keep-samples", arguments.calibration.keep_draws,
                   "Also write the draws of each joint, NAME_samples.h5; draw i of one joint "
                   "belongs to draw i of the others");
}

}  // namespace

void add_calibrate(CLI::App& program, Call& call) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* command = program.add_subcommand(
      "calibrate",
      "Slip-force densities of several joints of a structure from levels of its modes");
  command
      ->add_option("model", arguments->calibration.model,
                   "Model of the structure, model.toml; joints to be identified have "
                   "stiffness_N_per_m in place of file")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("levels", arguments->calibration.levels,
                   "Levels, one row per level: mode [1], displacement [m] at the response point, "
                   "dissipation [J] of all joints or damping_ratio [1]; optional: frequency [Hz], "
                   "amplitude_NAME [m], dissipation_NAME [J] of a joint, and _std of each")
      ->required()
      ->type_name(kCsvValue);
  command
      ->add_option("--out", arguments->calibration.out,
                   "Folder to write to, created if missing: NAME.json of each joint, model.toml "
                   "for predictions, calibration.csv, identifiability.csv")
      ->required()
      ->type_name(kFolderValue);
  add_method_options(*command, *arguments);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip calibrate model.toml modal_levels.csv --out found",
                "microslip backbone found/model.toml --response 1um:0.1mm:30:log --out b.csv",
                "microslip calibrate model.toml mode1.csv mode2.csv --frequency absolute \\",
                "          --stiffness fit --out found"});
  command->callback(
      [arguments, &call] { call.run = [arguments, &call] { return run(*arguments, call); }; });
}

}  // namespace microslip::app
