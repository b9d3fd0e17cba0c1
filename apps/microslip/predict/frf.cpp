// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/prediction.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/response/response_file.hpp"
#include "microslip/dynamics/harmonic/target.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/predict/response_draws.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

struct FrfOptions {
  PredictionArguments prediction;
  std::string force;
  std::string acceleration;
  std::string response;
  std::string frequency;
  std::string accuracy = "0.2%";
  std::string at;
  std::string peaks;
  DrawArguments draws;

  /// Whether the response is kept and the force found.
  [[nodiscard]] bool of_force() const { return force.empty() && acceleration.empty(); }
};

double parse_accuracy(const std::string& text) {
  const double accuracy = parse_quantity("--accuracy", text, kDimensionless);
  if (accuracy >= 1e-6 && accuracy <= 1.0) return accuracy;
  throw InputError("--accuracy", in_quotes(text), "must be from 0.0001% to 100%",
                   "0.05% gives twice as many points as 0.2%.");
}

std::vector<double> parse_at(const std::string& text, std::pair<double, double> range) {
  std::vector<double> frequencies;
  if (text.empty()) return frequencies;
  const auto [low, high] = std::minmax(range.first, range.second);
  for (const double frequency : parse_values("--at", text, kFrequency)) {
    if (!(frequency >= low && frequency <= high)) {
      throw InputError("--at", frequency,
                       fmt::format("must lie within --frequency, {:g} to {:g} Hz", low, high),
                       "Widen the range, or leave this frequency out.");
    }
    frequencies.push_back(kTwoPi * frequency);
  }
  return frequencies;
}

/// Quantity that the curve keeps constant, and kind of the response.
struct KeptTarget {
  Target target;
  ResponseKind kind = ResponseKind::kDisplacement;
};

/// A displacement, velocity or acceleration, by its unit; without one, m.
KeptTarget parse_response(const std::string& text) {
  if (is_quantity(text, kAcceleration)) {
    const double value = parse_quantity("--response", text, kAcceleration);
    return {{Quantity::kResponse, value}, ResponseKind::kAcceleration};
  }
  if (is_quantity(text, kVelocity)) {
    const double value = parse_quantity("--response", text, kVelocity);
    return {{Quantity::kResponse, value}, ResponseKind::kVelocity};
  }
  const double response = parse_quantity("--response", text, kLength);
  check_displacement("--response", response);
  return {{Quantity::kResponse, response}};
}

KeptTarget parse_kept(const FrfOptions& options) {
  if (!options.force.empty()) {
    return {{Quantity::kForceAmplitude, parse_force("--force", options.force)}};
  }
  if (options.acceleration.empty()) return parse_response(options.response);
  const double value = parse_quantity("--acceleration", options.acceleration, kAcceleration);
  if (value >= 1e-12 && value <= 1e12) return {{Quantity::kForceAmplitude, value}};
  throw InputError("--acceleration", value, "must be above 0 m/s^2: from 1e-12 to 1e12");
}

/// A force does not shake a base, nor an acceleration a point.
void check_drive(const FrfOptions& options, const ModelFile& model) {
  const std::string& place = model.structure.excitations().front().point;
  if (model.structure.base_driven() && !options.force.empty()) {
    throw InputError("--force", in_quotes(options.force),
                     fmt::format("must be left out: the model is driven by its base '{}'", place),
                     "Give --acceleration, for instance --acceleration 1g.");
  }
  if (!model.structure.base_driven() && !options.acceleration.empty()) {
    throw InputError("--acceleration", in_quotes(options.acceleration),
                     fmt::format("must be left out: the model is driven by a force at '{}'", place),
                     "Give --force, or let [excitation] of the model name a base.");
  }
}

ResponseRange range_of(const FrfOptions& options, const Target& kept) {
  const std::pair<double, double> range = parse_frequencies("--frequency", options.frequency);
  return {kept, kTwoPi * range.first, kTwoPi * range.second};
}

ResponseCurve curve_of(const HarmonicBalance& balance, const ResponseRange& range, bool quiet) {
  return balance.follow(range.kept, Quantity::kAngularFrequency, range.from, range.to, 0,
                        progress_bar("frequency", quiet));
}

/// Draws of a curve that did not converge are not taken.
std::optional<ResponseSpread> spread_of(const HarmonicBalance& balance, const ResponseCurve& curve,
                                        const ResponseRange& range,
                                        const std::optional<StructureDraws>& draws,
                                        const FrfOptions& options, bool quiet) {
  if (!draws || !curve.summary.converged()) return std::nullopt;
  return response_spread(balance, curve, range, *draws, draw_options(options.draws),
                         Execution::threads(), progress_bar("draws", quiet));
}

/// Of the curve: what drives where a response is kept, else the displacement.
CurveHeight height_of(const FrfOptions& options, const ModelFile& model) {
  return options.of_force() ? drive_of(model.structure) : displacement_height();
}

std::string heading_with_draws(const ResponseSpread& spread, const ModelFile& model,
                               const std::string& command, const CurveHeight& height) {
  std::string text =
      heading_of(command, model) + "\n" + draws_comment(spread.taken, uncertain_text(model));
  if (!spread.peaks.empty()) text += "\n" + peaks_comment(spread, height);
  return text;
}

/// Curve and peaks, both or none.
void write_spread(const FrfOptions& options, const ModelFile& model, const Call& call,
                  const HarmonicBalance& balance, const ResponseCurve& curve,
                  const ResponseSpread& spread) {
  const CurveHeight height = height_of(options, model);
  const std::string heading = heading_with_draws(spread, model, call.command_line, height);
  const std::vector<BandColumns> bands{
      {"", height.dimension, spread.band.lower, spread.band.upper}};
  OutputFiles outputs;
  outputs.add(options.prediction.out, response_table(balance, curve, heading, bands).str());
  if (!options.peaks.empty()) {
    outputs.add(options.peaks, peaks_table(spread, height, heading));
  }
  outputs.commit();
}

void check_frf_outputs(const FrfOptions& options) {
  std::vector<PlannedOutput> outputs{{options.prediction.out, kResponseKind}};
  if (!options.peaks.empty()) outputs.push_back({options.peaks, kPeaksKind});
  check_outputs(outputs);
}

std::string describe_spread(const std::optional<ResponseSpread>& spread, const ModelFile& model,
                            const CurveHeight& height) {
  if (!spread) return "";
  return describe_peak_spread(*spread, height) +
         describe_draws(spread->taken, uncertain_text(model));
}

int run(const FrfOptions& options, const Call& call) {
  check_frf_outputs(options);
  const KeptTarget kept = parse_kept(options);
  const ResponseRange range = range_of(options, kept.target);
  const ModelFile model = read_model(options.prediction.model);
  check_drive(options, model);
  std::optional<StructureDraws> draws;
  if (options.draws.any()) {
    draws = draws_of(model, options.prediction.model, draw_options(options.draws));
  }
  HarmonicBalanceOptions drawn;
  drawn.accuracy = parse_accuracy(options.accuracy);
  drawn.frequencies = parse_at(options.at, parse_frequencies("--frequency", options.frequency));
  const HarmonicBalance balance =
      balance_of(model, options.prediction, std::move(drawn), kept.kind);
  ResponseCurve curve = curve_of(balance, range, call.quiet);
  const std::string truncation = judge_response(
      balance, model, options.of_force() ? Quantity::kResponse : Quantity::kForceAmplitude, curve);
  const std::optional<ResponseSpread> spread =
      spread_of(balance, curve, range, draws, options, call.quiet);
  if (spread) std::ranges::copy(spread->warnings, std::back_inserter(curve.warnings));
  const auto summary = [&] {
    return describe_response(options.prediction.model, balance, curve, options.of_force()) +
           describe_spread(spread, model, height_of(options, model)) + truncation +
           describe_damping(model) + describe_warnings(curve.warnings);
  };
  if (!spread) {
    return finish(
        curve, options.prediction, call,
        [&] { return response_table(balance, curve, heading_of(call.command_line, model)); },
        summary);
  }
  write_spread(options, model, call, balance, curve, *spread);
  const int status = tell_ending(curve.summary, true, options.prediction, call, summary);
  return spread->taken.too_many_failed() ? kNotConverged : status;
}

void add_excitation(CLI::App& command, FrfOptions& options) {
  CLI::Option* force =
      command.add_option("--force", options.force, "Amplitude of the force, in N or with a unit");
  CLI::Option* response =
      command.add_option("--response", options.response,
                         "Constant amplitude at the response point, a displacement, velocity or "
                         "acceleration by its unit, default m, relative to a shaken base; the "
                         "force or base acceleration that it needs is computed");
  CLI::Option* acceleration = command.add_option(
      "--acceleration", options.acceleration,
      "Amplitude of the base acceleration, for a model with a driven base, in m/s^2 or with a "
      "unit");
  force->excludes(response)->excludes(acceleration);
  acceleration->excludes(response);
}

void add_frequencies(CLI::App& command, FrfOptions& options) {
  command
      .add_option("--frequency", options.frequency,
                  "FROM:TO, in Hz or with units; FROM above TO sweeps downward, onto the other "
                  "branch where there are two")
      ->required();
  command
      .add_option("--accuracy", options.accuracy,
                  "Tolerance of linear interpolation between the rows, relative to the peak; at "
                  "constant response relative to the force. From 0.0001%")
      ->capture_default_str();
  command.add_option(
      "--at", options.at,
      "Additional rows at these frequencies, on each branch: a comma-separated list, or "
      "FROM:TO:COUNT[:log], in Hz or with units");
}

}  // namespace

void add_frf(CLI::App& program, Call& call) {
  auto options = std::make_shared<FrfOptions>();
  CLI::App* command = program.add_subcommand(
      "frf",
      "Response of a structure with joints over frequency, at constant force or constant response");
  add_prediction_arguments(*command, options->prediction, call,
                           "frequency [Hz], force [N], displacement [m], phase [rad], velocity "
                           "[m/s], acceleration [m/s^2]; with a shaken base base_acceleration "
                           "[m/s^2] instead of the force, absolute_displacement [m], "
                           "absolute_acceleration [m/s^2], transmissibility [1]");
  add_excitation(*command, *options);
  add_frequencies(*command, *options);
  add_draw_arguments(*command, options->draws,
                     "lower and upper, of the displacement [m], or at constant response of the "
                     "force or base acceleration");
  add_correlation_argument(*command, options->draws);
  command
      ->add_option("--peaks-csv", options->peaks, "Peaks as CSV, with their bands from the draws")
      ->needs(command->get_option("--draws"))
      ->type_name(kCsvValue);
  add_examples(*command,
               {"microslip frf model.toml --force 0.1 --frequency 0.1:0.2 --out frf.csv",
                "microslip frf model.toml --force 0.1 --frequency 0.1:0.2 --draws 1000 \\",
                "          --out frf.csv --peaks-csv peaks.csv",
                "microslip frf model.toml --response 800mm --frequency 0.14:0.17 \\",
                "          --harmonics 9 --out frf.csv",
                "microslip frf model.toml --response 1m/s^2 --frequency 0.14:0.17 --out frf.csv",
                "microslip frf shaken.toml --acceleration 0.5g --frequency 20:200 --out frf.csv",
                "microslip frf model.toml --force 0.1 --frequency 0.2:0.1 --accuracy 0.05% \\",
                "          --at 0.14,0.15 --out frf.csv"});
  command->callback([options, &call] {
    if (options->force.empty() && options->acceleration.empty() && options->response.empty()) {
      throw CLI::RequiredError("--force, --acceleration or --response");
    }
    call.run = [options, &call] { return run(*options, call); };
  });
}

}  // namespace microslip::app
