// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/target.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/response_file.hpp"
#include "microslip/io/text.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "prediction.hpp"
#include "progress_bar.hpp"
#include "report_text.hpp"

namespace microslip::app {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kHighestFrequency = 1e9;  // Hz

struct FrfOptions {
  PredictionArguments prediction;
  std::string force;
  std::string response;
  std::string frequency;
  std::string accuracy = "0.2%";
  std::string at;
};

std::pair<double, double> parse_frequencies(const std::string& text) {
  const auto [from, to] = parse_way("--frequency", text, kFrequency);
  if (!(from > 0.0)) throw InputError("FROM of --frequency", from, "must be above 0 Hz");
  if (!(to > 0.0)) throw InputError("TO of --frequency", to, "must be above 0 Hz");
  if (!(from <= kHighestFrequency)) {
    throw InputError("FROM of --frequency", from, "must be 1e9 or less");
  }
  if (!(to <= kHighestFrequency)) throw InputError("TO of --frequency", to, "must be 1e9 or less");
  return {from, to};
}

double parse_accuracy(const std::string& text) {
  const double accuracy = parse_quantity("--accuracy", text, kDimensionless);
  if (accuracy >= 1e-6 && accuracy <= 1.0) return accuracy;
  throw InputError("--accuracy", in_quotes(text), "must be from 0.0001% to 100%",
                   "0.05% draws twice as many points as 0.2%.");
}

std::vector<double> parse_at(const std::string& text, std::pair<double, double> range) {
  std::vector<double> frequencies;
  if (text.empty()) return frequencies;
  const auto [low, high] = std::minmax(range.first, range.second);
  for (const double frequency : parse_values("--at", text, kFrequency)) {
    if (!(frequency >= low && frequency <= high)) {
      throw InputError("--at", frequency,
                       fmt::format("must lie in --frequency, {:g} to {:g} Hz", low, high),
                       "Widen the range, or leave this frequency out.");
    }
    frequencies.push_back(kTwoPi * frequency);
  }
  return frequencies;
}

ResponseCurve curve_of(const HarmonicBalance& balance, const FrfOptions& options,
                       std::pair<double, double> range, bool quiet) {
  const double from = kTwoPi * range.first;
  const double to = kTwoPi * range.second;
  const Progress progress = progress_bar("frequency", quiet);
  if (!options.force.empty()) {
    const double force = parse_force("--force", options.force);
    return balance.frequency_response(force, from, to, progress);
  }
  const double response = parse_quantity("--response", options.response, kLength);
  check_displacement("--response", response);
  return balance.constant_response(response, from, to, progress);
}

/// What a reader of the table must know: the summary says it too.
void add_curve_warnings(const HarmonicBalance& balance, const ModelFile& model,
                        ResponseCurve& curve) {
  add_model_warnings(model, curve);
  if (!curve.summary.converged() || !curve.peaks.empty()) return;
  curve.warnings.push_back(
      {"no_resonance", fmt::format("no resonance in the range. With all joints stuck the structure "
                                   "is resonant at {}; slip lowers that.",
                                   stuck_frequencies_text(balance.structure()))});
}

std::string describe_peaks(const ResponseCurve& curve, bool of_force) {
  std::string text;
  for (const SteadyVibration& peak : curve.peaks) {
    // Far from a lag of a quarter, as in a superharmonic resonance, the losses are not those of a
    // mode.
    const bool in_resonance = std::abs(std::sin(peak.phase_lag)) > 0.5;
    const std::string damping = in_resonance ? fmt::format("damping {:.4g}", peak.damping_ratio())
                                             : "not in phase resonance";
    text += line(of_force ? "resonance" : "peak",
                 fmt::format("{:.6g} Hz, {:.5g} {}, lag {:.4g} rad, {}", peak.frequency(),
                             of_force ? peak.force_amplitude : peak.response, of_force ? "N" : "m",
                             peak.phase_lag, damping));
  }
  for (const std::size_t i : curve.turning_points) {
    if (i >= curve.points.size()) continue;
    text += line("turns back", fmt::format("at {:.6g} Hz, {:.5g} m", curve.points[i].frequency(),
                                           curve.points[i].response));
  }
  return text;
}

std::string describe(const HarmonicBalance& balance, const ResponseCurve& curve,
                     const FrfOptions& options) {
  const bool of_force = options.force.empty();
  const SteadyVibration& first = curve.points.front();
  std::string text = of_force
                         ? fmt::format("Force for a response of {:g} m\n", first.response)
                         : fmt::format("Frequency response at {:g} N\n", first.force_amplitude);
  text += describe_curve(balance, curve, options.prediction);
  const auto [lowest, highest] =
      std::ranges::minmax(curve.points, {}, &SteadyVibration::angular_frequency);
  text += line("range", fmt::format("{:.6g} to {:.6g} Hz, {} points", lowest.frequency(),
                                    highest.frequency(), curve.points.size()));
  const auto [least, most] = std::ranges::minmax(
      curve.points, {}, of_force ? &SteadyVibration::force_amplitude : &SteadyVibration::response);
  text +=
      of_force
          ? line("force",
                 fmt::format("{:.5g} to {:.5g} N", least.force_amplitude, most.force_amplitude))
          : line("displacement", fmt::format("{:.5g} to {:.5g} m", least.response, most.response));
  return text + describe_peaks(curve, of_force);
}

int run(const FrfOptions& options, const Call& call) {
  check_output(options.prediction.out, kResponseKind);
  const std::pair<double, double> range = parse_frequencies(options.frequency);
  const ModelFile model = read_model(options.prediction.model);
  HarmonicBalanceOptions drawn;
  drawn.accuracy = parse_accuracy(options.accuracy);
  drawn.frequencies = parse_at(options.at, range);
  const HarmonicBalance balance = balance_of(model, options.prediction, std::move(drawn));
  ResponseCurve curve = curve_of(balance, options, range, call.quiet);
  const std::string truncation = add_truncation(
      balance, options.force.empty() ? Quantity::kResponse : Quantity::kForceAmplitude, curve);
  add_curve_warnings(balance, model, curve);
  return finish(
      curve, options.prediction, call,
      [&] { return response_table(curve, heading_of(call, model)); },
      [&] {
        return describe(balance, curve, options) + truncation + describe_damping(model) +
               describe_warnings(curve.warnings);
      });
}

}  // namespace

void add_frf(CLI::App& program, Call& call) {
  auto options = std::make_shared<FrfOptions>();
  CLI::App* command = program.add_subcommand(
      "frf",
      "Response of a structure with joints over the frequency, at one force or one response");
  add_prediction_arguments(*command, options->prediction, call,
                           "frequency [Hz], force [N], displacement [m], phase [rad]");
  CLI::Option* force =
      command->add_option("--force", options->force, "Amplitude of the force, in N or with a unit");
  CLI::Option* response = command->add_option(
      "--response", options->response,
      "Amplitude of the displacement at the response point that is kept, in m or with a unit: the "
      "force is what is found");
  force->excludes(response);
  command
      ->add_option(
          "--frequency", options->frequency,
          "FROM:TO, in Hz or with units; FROM above TO goes downward, onto the other branch "
          "where there are two")
      ->required();
  command
      ->add_option("--accuracy", options->accuracy,
                   "How far the polygon through the rows may lie beside the curve, relative to its "
                   "peak; at constant response relative to the force. From 0.0001%")
      ->capture_default_str();
  command->add_option(
      "--at", options->at,
      "Rows at these frequencies as well, on each branch: a list between commas, or "
      "FROM:TO:COUNT[:log], in Hz or with units");
  add_examples(*command,
               {"microslip frf model.toml --force 0.1 --frequency 0.1:0.2 --out frf.csv",
                "microslip frf model.toml --response 800mm --frequency 0.14:0.17 --harmonics 9 \\",
                "          --out frf.csv",
                "microslip frf model.toml --force 0.1 --frequency 0.2:0.1 --accuracy 0.05% \\",
                "          --at 0.14,0.15 --out frf.csv"});
  command->callback([options, &call] {
    if (options->force.empty() && options->response.empty()) {
      throw CLI::RequiredError("--force or --response");
    }
    call.run = [options, &call] { return run(*options, call); };
  });
}

}  // namespace microslip::app
