// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "draw_arguments.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/report/gnuplot.hpp"
#include "microslip/report/verification_figure.hpp"
#include "microslip/workflow/recordings_verification.hpp"
#include "microslip/workflow/verification_text.hpp"
#include "picture_argument.hpp"
#include "progress_bar.hpp"
#include "recording_arguments.hpp"

namespace microslip::app {
namespace {

struct VerifyOptions : RecordingsVerification {
  VerificationTables tables;
  std::string picture;
  std::string frequency;
  std::size_t harmonics = 10;
  bool no_vibrometer = false;
  RecordingArguments arguments;
  JointDrawArguments drawn;
  std::string frequency_std = "0";
  std::string loss_factor_std = "0";
  std::string force_gain_std = "0";
  std::string acceleration_gain_std = "0";
};

std::optional<RecordingsDraws> recordings_draws(const VerifyOptions& options, bool quiet) {
  if (!options.drawn.any()) return std::nullopt;
  const JointUncertainty joint = uncertainty_of(options.drawn);
  RecordingsDraws draws;
  draws.options = draw_options(options.drawn);
  draws.samples = joint.samples;
  draws.rig = {
      .frequency = parse_spread("--frequency-std", options.frequency_std),
      .loss_factor = parse_spread("--loss-factor-std", options.loss_factor_std),
      .normal_load = joint.normal_load,
      .force_gain = parse_spread("--force-gain-std", options.force_gain_std),
      .acceleration_gain = parse_spread("--acceleration-gain-std", options.acceleration_gain_std)};
  draws.progress = progress_bar("draws", quiet);
  return draws;
}

std::vector<PlannedOutput> outputs_of(const VerifyOptions& options) {
  std::vector<PlannedOutput> outputs = planned(options.tables);
  if (!options.picture.empty()) {
    (void)picture_format("--picture", options.picture);
    outputs.push_back({options.picture});
  }
  return outputs;
}

void write_outputs(const VerifyOptions& options, const VerifiedRecordings& verified,
                   const std::string& command) {
  OutputFiles outputs;
  add_tables(verified, options.tables, command, outputs);
  if (!options.picture.empty()) {
    ExperimentResults results;
    add_verified(verified.batch.records, results);
    const FigureGrid figure = verification_figure(results);
    outputs.add(options.picture, draw(figure, picture_format("--picture", options.picture),
                                      verification_size(figure)));
  }
  outputs.commit();
}

int run(VerifyOptions options, const Call& call) {
  check_outputs(outputs_of(options));
  ReductionOptions& reduction = options.verification.reduction;
  reduction.fit.order = static_cast<int>(options.harmonics);
  reduction.fit.frequency_guess = frequency_guess(options.frequency);
  reduction.use_vibrometer = !options.no_vibrometer;
  options.reading = read_options(options.arguments);
  options.progress = progress_bar("records", call.quiet);
  options.draws = recordings_draws(options, call.quiet);
  const VerifiedRecordings verified = verify_recordings(options);
  if (!call.quiet) std::ranges::for_each(verified.warnings, show_warnings);
  const VerificationBatch& batch = verified.batch;
  write_outputs(options, verified, call.command_line);
  if (!call.quiet) {
    const bool data_on_stdout = options.tables.table == "-" || options.tables.harmonics == "-" ||
                                options.tables.histories == "-";
    fmt::print(data_on_stdout ? stderr : stdout, "{}",
               describe_verification(verified.verifier, batch) +
                   (verified.spread ? describe_checked(*verified.spread) : ""));
  }
  const bool failed = verified.spread && verified.spread->taken.too_many_failed();
  return batch.converged() && !failed ? kDone : kNotConverged;
}

void add_output_options(CLI::App& command, VerifyOptions& options) {
  command
      .add_option("--out", options.tables.table,
                  "CSV to write, a row a record and channel: NRMSE [1], noise_share [1], "
                  "amplitude_ratio [1], phase_error [rad], ...; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command
      .add_option("--harmonics-csv", options.tables.harmonics,
                  "Harmonics of each channel as CSV, recorded and predicted")
      ->type_name(kCsvValue);
  command
      .add_option("--histories", options.tables.histories,
                  "A few cycles of each channel as CSV, recorded and predicted")
      ->type_name(kCsvValue);
  command
      .add_option("--picture", options.picture,
                  "Lowest, middle and highest level as .svg, .png or .pdf")
      ->type_name(kPictureValue);
}

void add_model_options(CLI::App& command, VerifyOptions& options) {
  command
      .add_option("--modes", options.verification.reduction.modes, "Modes of the beam in the model")
      ->check(CLI::Range(1, 40))
      ->capture_default_str();
  command.add_option("--harmonics", options.harmonics, "Harmonics that are fitted and compared")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_flag("--sine", options.verification.sine,
                   "Drive the model by a pure sine, not with the recorded harmonics of the force");
  command.add_option("--frequency", options.frequency,
                     "Frequency of the drive, to 3 %, in Hz; found if it is not given");
  command
      .add_option("--cycles", options.verification.history_cycles,
                  "Length of the histories, in cycles")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  command.add_flag("--no-vibrometer", options.no_vibrometer,
                   "Leave the vibrometer out, even if there is one");
}

void add_rig_draws(CLI::App& command, VerifyOptions& options) {
  add_joint_draw_arguments(
      command, options.drawn,
      "predicted_response_lower and predicted_response_upper [m/s^2] at the recorded force, the "
      "same of the frequency there, of the joint's amplitude and of the energy input, and 1 or 0 "
      "for whether what was measured lies inside");
  CLI::Option* draws = command.get_option("--draws");
  const auto add = [&](const char* name, std::string& value, const char* text) {
    command.add_option(name, value, text)->needs(draws)->capture_default_str();
  };
  add("--frequency-std", options.frequency_std,
      "Relative standard deviation of each frequency of the rig without the joint's slip");
  add("--loss-factor-std", options.loss_factor_std, "The same of each loss factor of the rig");
  add("--force-gain-std", options.force_gain_std, "The same of the reading of the force");
  add("--acceleration-gain-std", options.acceleration_gain_std,
      "The same of the readings of the accelerometers, of all alike");
}

}  // namespace

void add_verify(CLI::App& program, Call& call) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = program.add_subcommand(
      "verify", "Recordings of a frictional-support test against what a joint predicts");
  command->add_option("rig", options->rig, "Description of the test, rig.toml")
      ->required()
      ->type_name(kTomlValue);
  command->add_option("joint", options->joint, "The joint, joint.json")
      ->required()
      ->type_name(kJsonValue);
  command
      ->add_option("recordings", options->recordings,
                   "Steady records, one a level (CSV, UFF, MAT, HDF5)")
      ->required()
      ->type_name(kRecordingValue);
  add_output_options(*command, *options);
  add_model_options(*command, *options);
  add_rig_draws(*command, *options);
  add_recording_arguments(*command, options->arguments);
  command->add_flag("--skip-faulty", options->skip_faulty,
                    "Leave out what cannot be read or fitted, and say so");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip verify rig.toml joint.json level_*.csv --out verification.csv",
                          "microslip verify rig.toml joint.json test.h5 --out verification.csv \\",
                          "          --histories histories.csv --picture verification.svg",
                          "microslip verify rig.toml joint.json level_*.csv --draws 200 \\",
                          "          --samples joint_samples.h5 --frequency-std 0.05% \\",
                          "          --loss-factor-std 5% --out verification.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
