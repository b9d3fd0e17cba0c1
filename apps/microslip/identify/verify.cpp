// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/picture_argument.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "identify/verify_tests.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/report/drawing/gnuplot.hpp"
#include "microslip/report/figures/verification_figure.hpp"
#include "microslip/workflow/compare/recordings_verification.hpp"
#include "microslip/workflow/compare/verification_text.hpp"
#include "microslip/workflow/results/verified_results.hpp"

namespace microslip::app {
namespace {

constexpr std::size_t kRigHarmonics = 10;

struct VerifyOptions : RecordingsVerification {
  std::vector<std::string> tests;
  VerificationTables tables;
  std::string picture;
  std::string frequency;
  std::optional<std::size_t> harmonics;
  bool no_vibrometer = false;
  RecordingArguments arguments;
  JointDrawArguments drawn;
  TestArguments of_tests;
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

/// Refuses a joint among the recordings, which are opened for that.
void require_no_joint_behind(const VerifyOptions& options) {
  const auto joint = std::ranges::find(options.recordings, kJointKind, kind_of_file);
  if (joint == options.recordings.end()) return;
  throw InputError(*joint, known_kind(kJointKind)->words, "must be named directly after rig.toml",
                   fmt::format("Name {} after it.", options.joint));
}

/// The joint and the recordings of a rig.
void name_inputs(VerifyOptions& options) {
  const auto require_rig = [&] {  // it may be no rig, or missing
    if (options.rig != "-") (void)parse_rig(read_file(options.rig), options.rig);
  };
  options.joint = options.tests.front();
  options.recordings.assign(options.tests.begin() + 1, options.tests.end());
  const KnownKind* const known = known_kind(kind_of_file(options.joint));
  const bool is_joint = known != nullptr && known->kind == kJointKind;
  if (!is_joint) require_no_joint_behind(options);
  if (known != nullptr && !is_joint) {
    require_rig();
    throw InputError(options.joint, known->words,
                     "must be a joint.json after a rig.toml, followed by its records",
                     "Use a model.toml instead of the rig.toml for sweeps and ring-downs.");
  }
  if (!options.recordings.empty()) return;
  require_rig();
  throw InputError("recordings", InputState{"missing"},
                   "must be named after rig.toml and joint.json",
                   "For instance: microslip verify rig.toml joint.json level_01.csv --out "
                   "verification.csv");
}

int run_of_rig(VerifyOptions options, const Call& call) {
  name_inputs(options);
  check_outputs(outputs_of(options));
  ReductionOptions& reduction = options.verification.reduction;
  reduction.fit.order = static_cast<int>(options.harmonics.value_or(kRigHarmonics));
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
    print_text(data_on_stdout ? stderr : stdout,
               describe_verification(verified.verifier, batch) +
                   (verified.spread ? describe_checked(*verified.spread) : ""));
  }
  const bool failed = verified.spread && verified.spread->taken.too_many_failed();
  return batch.converged() && !failed ? kDone : kNotConverged;
}

/// Options for a rig only, and for tests of a model only.
constexpr std::array kOfRig{"--harmonics-csv",  "--histories",     "--modes",
                            "--sine",           "--frequency",     "--cycles",
                            "--no-vibrometer",  "--frequency-std", "--loss-factor-std",
                            "--force-gain-std", "--skip-faulty",   "--acceleration-gain-std"};
constexpr std::array kOfTests{"--kind",         "--sensor", "--mode",       "--force",
                              "--displacement", "--joint",  "--correlation"};

template <std::size_t N>
void refuse_options(const CLI::App& command, const std::array<const char*, N>& names,
                    const char* with) {
  for (const char* name : names) {
    if (command.get_option(name)->count() == 0) continue;
    throw InputError(name, InputState{"given"}, fmt::format("must not be given {}", with),
                     "Leave it out.");
  }
}

void check_cycles(const VerifyOptions& options, const CLI::App& command) {
  const bool shown = !options.tables.histories.empty() || !options.picture.empty();
  if (shown || command.get_option("--cycles")->count() == 0) return;
  throw InputError("--cycles", options.verification.history_cycles,
                   "has no effect: it is the length of the histories of --histories and --picture",
                   "Leave it out, or ask for one of them.");
}

bool predicts(std::string_view kind) {
  return kind == kRigKind || kind == kModelKind || kind == kJointKind;
}

/// Reports a file of another kind before missing arguments after it.
void check_description(const VerifyOptions& options, std::string_view kind) {
  const KnownKind* const known = known_kind(kind);
  if (known == nullptr || predicts(kind)) return;
  const auto first = std::ranges::find_if(
      options.tests, [](const std::string& test) { return predicts(kind_of_file(test)); });
  throw InputError(options.rig, known->words, "must be a rig.toml, model.toml or joint.json",
                   first == options.tests.end()
                       ? std::string("Name the predicting file first, then the tests.")
                       : fmt::format("Name the predicting file first: {} before it.", *first));
}

int run(const VerifyOptions& options, const CLI::App& command, const Call& call) {
  // A pipe can be read only once: it is taken as a rig, as is an unreadable file, which the reader
  // of the rig reports after faults of the outputs.
  const std::string kind = kind_of_file(options.rig);
  check_description(options, kind);
  if (kind != kModelKind && kind != kJointKind) {
    refuse_options(command, kOfTests, "with a rig.toml, whose records are steady");
    check_cycles(options, command);
    return run_of_rig(options, call);
  }
  refuse_options(command, kOfRig,
                 "with a model.toml or joint.json: it applies to records of a rig");
  return run_of_tests({.model = options.rig,
                       .tests = options.tests,
                       .out = options.tables.table,
                       .picture = options.picture,
                       .harmonics = options.harmonics,
                       .arguments = options.of_tests,
                       .reading = options.arguments,
                       .drawn = options.drawn},
                      call);
}

void add_output_options(CLI::App& command, VerifyOptions& options) {
  command
      .add_option(
          "--out", options.tables.table,
          "CSV to write. Rig: one row per record and channel: NRMSE [1], noise_share [1], "
          "amplitude_ratio [1], phase_error [rad], ...; tests of a model: one row per value: "
          "quantity, measured, predicted, lower, upper, verdict, ...; - is standard output")
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
      .add_option(
          "--picture", options.picture,
          "Lowest, middle and highest level of a rig, or the tests of a model, as .svg, .png "
          "or .pdf")
      ->type_name(kPictureValue);
}

void add_model_options(CLI::App& command, VerifyOptions& options) {
  command
      .add_option("--modes", options.verification.reduction.modes, "Modes of the beam in the model")
      ->check(CLI::Range(1, 40))
      ->capture_default_str();
  command
      .add_option("--harmonics", options.harmonics,
                  "Number of harmonics fitted and compared, default 10; for tests of a model those "
                  "of its motion, default 5")
      ->check(CLI::Range(1, 100));
  command.add_flag(
      "--sine", options.verification.sine,
      "Drive the model with a pure sine, not with the recorded harmonics of the force");
  command.add_option("--frequency", options.frequency,
                     "Drive frequency, to within 3 %, in Hz; default: detected");
  command
      .add_option("--cycles", options.verification.history_cycles,
                  "Length of the histories, in cycles")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  command.add_flag("--no-vibrometer", options.no_vibrometer,
                   "Do not use the vibrometer, even if there is one");
}

void add_rig_draws(CLI::App& command, VerifyOptions& options) {
  add_joint_draw_arguments(
      command, options.drawn,
      "predicted_response_lower and predicted_response_upper [m/s^2] at the recorded force, the "
      "band of the frequency there, of the joint's amplitude and of the energy input, and 1 or 0 "
      "for whether the measured value lies inside; tests of a model: lower, upper and verdict");
  add_correlation_argument(command, options.drawn);
  CLI::Option* draws = command.get_option("--draws");
  const auto add = [&](const char* name, std::string& value, const char* text) {
    command.add_option(name, value, text)->needs(draws)->capture_default_str();
  };
  add("--frequency-std", options.frequency_std,
      "Relative standard deviation of each frequency of the rig without slip");
  add("--loss-factor-std", options.loss_factor_std,
      "Relative standard deviation of each loss factor of the rig");
  add("--force-gain-std", options.force_gain_std,
      "Relative standard deviation of the gain of the force sensor");
  add("--acceleration-gain-std", options.acceleration_gain_std,
      "Relative standard deviation of the gain common to all accelerometers");
}

}  // namespace

void add_verify(CLI::App& program, Call& call) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      program.add_subcommand("verify",
                             "Compare tests with predictions: recordings of a frictional-support "
                             "test by its joint, or sweeps, ring-downs and loops by a model");
  command
      ->add_option("description", options->rig,
                   "Description of a frictional-support test, rig.toml; or a structure with "
                   "joints, model.toml; or a single joint, joint.json, for loops")
      ->required()
      ->type_name(kDescriptionValue);
  command
      ->add_option(
          "tests", options->tests,
          "With a rig.toml: its joint, joint.json, and steady records, one per level (CSV, UFF, "
          "MAT, HDF5). Otherwise tests: stepped-sine tables (CSV with frequency [Hz], "
          "force [N], acceleration [m/s^2], phase [rad], or FILE.mat:VARIABLE with such "
          "fields), modal_levels.csv, recordings of a ring-down or of force and "
          "displacement")
      ->required()
      ->type_name(kTestValue);
  add_output_options(*command, *options);
  add_model_options(*command, *options);
  add_rig_draws(*command, *options);
  add_test_arguments(*command, options->of_tests);
  add_recording_arguments(*command, options->arguments);
  command->add_flag("--skip-faulty", options->skip_faulty,
                    "Leave out, and list, what cannot be read or fitted");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip verify rig.toml joint.json level_*.csv --out verification.csv",
                          "microslip verify rig.toml joint.json test.h5 --out verification.csv \\",
                          "          --histories histories.csv --picture verification.svg",
                          "microslip verify rig.toml joint.json level_*.csv --draws 200 \\",
                          "          --samples joint_samples.h5 --frequency-std 0.05% \\",
                          "          --loss-factor-std 5% --out verification.csv",
                          "microslip verify model.toml sweep_1.csv sweep_2.csv --draws 1000 \\",
                          "          --out comparison.csv --picture comparison.svg",
                          "microslip verify joint.json record.csv --out comparison.csv"});
  command->callback([options, command, &call] {
    call.run = [options, command, &call] { return run(*options, *command, call); };
  });
}

}  // namespace microslip::app
