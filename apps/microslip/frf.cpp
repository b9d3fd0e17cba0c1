// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
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
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "prediction.hpp"
#include "progress_bar.hpp"

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
  for (const auto& [end, value] : {std::pair{"FROM", from}, std::pair{"TO", to}}) {
    const std::string name = fmt::format("{} of --frequency", end);
    if (!(value > 0.0)) throw InputError(name, value, "must be above 0 Hz");
    if (!(value <= kHighestFrequency)) throw InputError(name, value, "must be 1e9 or less");
  }
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
  add_response_warnings(balance, model, curve);
  return finish(
      curve, options.prediction, call,
      [&] { return response_table(curve, heading_of(call.command_line, model)); },
      [&] {
        return describe_response(options.prediction.model, balance, curve, options.force.empty()) +
               truncation + describe_damping(model) + describe_warnings(curve.warnings);
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
