// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/target.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/response_file.hpp"
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
};

std::pair<double, double> parse_frequencies(const std::string& text) {
  const auto [from, to] = parse_interval("--frequency", text, kFrequency);
  if (!(from > 0.0)) throw InputError("FROM of --frequency", from, "must be above 0 Hz");
  if (!(to <= kHighestFrequency)) throw InputError("TO of --frequency", to, "must be 1e9 or less");
  return {from, to};
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

std::string describe_peaks(const ResponseCurve& curve, bool of_force) {
  std::string text;
  for (const SteadyVibration& peak : curve.peaks) {
    // Far from a lag of a quarter, as in a superharmonic resonance, the losses are not those of a mode.
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
  text += describe_peaks(curve, of_force);
  if (curve.summary.converged() && curve.peaks.empty()) {
    text += wrapped("  warning: ",
                    fmt::format("no resonance in the range. With all joints stuck the structure "
                                "is resonant at {}; slip lowers that.",
                                stuck_frequencies_text(balance.structure())),
                    11);
  }
  return text;
}

int run(const FrfOptions& options, const Call& call) {
  check_output(options.prediction.out, kResponseKind);
  const std::pair<double, double> range = parse_frequencies(options.frequency);
  const ModelFile model = read_model(options.prediction.model);
  const HarmonicBalance balance = balance_of(model, options.prediction);
  ResponseCurve curve = curve_of(balance, options, range, call.quiet);
  add_reach_warnings(model, curve);
  return finish(
      curve, options.prediction, call, [&] { return response_table(curve, heading_of(call)); },
      [&] { return describe(balance, curve, options) + describe_warnings(curve.warnings); });
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
  command->add_option("--frequency", options->frequency, "FROM:TO, in Hz or with units")
      ->required();
  add_examples(*command,
               {"microslip frf model.toml --force 0.1 --frequency 0.1:0.2 --out frf.csv",
                "microslip frf model.toml --response 800mm --frequency 0.14:0.17 --harmonics 9 \\",
                "          --out frf.csv"});
  command->callback([options, &call] {
    if (options->force.empty() && options->response.empty()) {
      throw CLI::RequiredError("--force or --response");
    }
    call.run = [options, &call] { return run(*options, call); };
  });
}

}  // namespace microslip::app
