// SPDX-License-Identifier: MIT

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/prediction.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/response/response_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/predict/backbone_draws.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct BackboneOptions {
  PredictionArguments prediction;
  std::string response;
  std::string mode = "1";
  std::string forcing = "excitation";
  DrawArguments draws;
};

std::vector<double> responses_of(const BackboneOptions& options) {
  std::vector<double> responses = parse_range("--response", options.response, kLength);
  check_displacement("FROM of --response", responses.front());
  check_displacement("TO of --response", responses.back());
  return responses;
}

/// The number of the mode is as the user gave it, from 1.
ResponseCurve curve_of(const HarmonicBalance& balance, const BackboneOptions& options,
                       const std::vector<double>& responses, std::size_t mode, bool quiet) {
  try {
    ResponseCurve curve = balance.resonances(responses, mode - 1, progress_bar("responses", quiet));
    if (!curve.summary.converged() && options.forcing != "modal") {
      curve.summary.reason += " (--forcing modal)";
    }
    return curve;
  } catch (const InputError& error) {
    if (error.name() == "mode with modal forcing") {
      throw error.renamed("--mode " + options.mode + " with --forcing modal");
    }
    if (error.name() != "mode") throw;
    throw InputError("--mode", options.mode,
                     "must be elastic: with all joints stuck this one is a rigid-body mode",
                     "Take a higher mode.");
  }
}

std::optional<StructureDraws> draws_of_model(const ModelFile& model,
                                             const BackboneOptions& options) {
  if (!options.draws.any()) return std::nullopt;
  return draws_of(model, options.prediction.model, draw_options(options.draws));
}

/// Draws of a backbone that did not converge are not taken.
std::optional<BackboneSpread> spread_of(const HarmonicBalance& balance, const ResponseCurve& curve,
                                        std::size_t mode,
                                        const std::optional<StructureDraws>& draws,
                                        const BackboneOptions& options, bool quiet) {
  if (!draws || !curve.summary.converged()) return std::nullopt;
  return backbone_spread(balance, curve, responses_of(options), mode - 1, *draws,
                         draw_options(options.draws), Execution::threads(),
                         progress_bar("draws", quiet));
}

CsvWriter table_of(const HarmonicBalance& balance, const ResponseCurve& curve,
                   const std::optional<BackboneSpread>& spread, const ModelFile& model,
                   const std::string& command) {
  const std::string heading = heading_of(command, model);
  if (!spread) return backbone_table(balance, curve, heading);
  const CurveHeight drive = drive_column(balance);
  const std::vector<BandColumns> bands{
      {std::string(drive.name), drive.dimension, spread->force.lower, spread->force.upper},
      {"frequency", kFrequency, spread->frequency.lower, spread->frequency.upper},
      {"damping_ratio", kDimensionless, spread->damping_ratio.lower, spread->damping_ratio.upper}};
  return backbone_table(
      balance, curve, heading + "\n" + draws_comment(spread->taken, uncertain_text(model)), bands);
}

int run(const BackboneOptions& options, const Call& call) {
  check_output(options.prediction.out, kBackboneKind);
  const std::vector<double> responses = responses_of(options);
  const ModelFile model = read_model(options.prediction.model);
  const std::size_t mode =
      parse_whole_number("--mode", options.mode, 1, model.structure.linear().vibrations(),
                         "The model has that many modes.");
  const std::optional<StructureDraws> draws = draws_of_model(model, options);
  const Forcing forcing = options.forcing == "modal" ? Forcing::kModal : Forcing::kExcitation;
  const HarmonicBalance balance = balance_of(model, options.prediction, {.forcing = forcing});
  ResponseCurve curve = curve_of(balance, options, responses, mode, call.quiet);
  const std::string truncation = judge_backbone(balance, model, curve);
  const std::optional<BackboneSpread> spread =
      spread_of(balance, curve, mode, draws, options, call.quiet);
  if (spread) std::ranges::copy(spread->warnings, std::back_inserter(curve.warnings));
  const int status = finish(
      curve, options.prediction, call,
      [&] { return table_of(balance, curve, spread, model, call.command_line); },
      [&] {
        return describe_backbone(options.prediction.model, balance, curve, mode) +
               (spread ? describe_draws(spread->taken, uncertain_text(model)) : "") + truncation +
               describe_damping(model) + describe_warnings(curve.warnings);
      });
  return spread && spread->taken.too_many_failed() ? kNotConverged : status;
}

}  // namespace

void add_backbone(CLI::App& program, Call& call) {
  auto options = std::make_shared<BackboneOptions>();
  CLI::App* command = program.add_subcommand(
      "backbone", "Resonance frequency and damping of a structure with joints over amplitude");
  add_prediction_arguments(*command, options->prediction, call,
                           "displacement [m], force [N], frequency [Hz], damping_ratio [1]; with a "
                           "shaken base base_acceleration [m/s^2] instead of the force");
  command
      ->add_option("--response", options->response,
                   "Amplitudes of the displacement at the response point, FROM:TO:COUNT[:log], in "
                   "m or with units; :log for equal ratios")
      ->required();
  command
      ->add_option("--mode", options->mode,
                   "Number of the mode, by frequency with all joints stuck")
      ->capture_default_str();
  command
      ->add_option(
          "--forcing", options->forcing,
          "Forcing: the excitation of the model, or a force at every mass that balances the "
          "dissipation there. The latter gives the nonlinear mode itself, independent of the drive "
          "point; the column force is then the one with the same input at the response "
          "point")
      ->check(CLI::IsMember({"excitation", "modal"}))
      ->capture_default_str();
  add_draw_arguments(
      *command, options->draws,
      "force_lower and force_upper [N], and those of frequency [Hz] and damping_ratio [1]");
  add_correlation_argument(*command, options->draws);
  add_examples(*command,
               {"microslip backbone model.toml --response 10mm:2:40:log --out backbone.csv",
                "microslip backbone model.toml --response 10mm:2:40:log --forcing modal \\",
                "          --out mode.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
