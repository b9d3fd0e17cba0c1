// SPDX-License-Identifier: MIT

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/response_file.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "prediction.hpp"
#include "progress_bar.hpp"

namespace microslip::app {
namespace {

struct BackboneOptions {
  PredictionArguments prediction;
  std::string response;
  std::string mode = "1";
  std::string forcing = "excitation";
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
                     "must be one that vibrates: with all joints stuck this is a rigid body",
                     "Take a higher mode.");
  }
}

int run(const BackboneOptions& options, const Call& call) {
  check_output(options.prediction.out, kBackboneKind);
  const std::vector<double> responses = responses_of(options);
  const ModelFile model = read_model(options.prediction.model);
  const std::size_t mode =
      parse_whole_number("--mode", options.mode, 1, model.structure.linear().size(),
                         "That is how many modes the model has.");
  const Forcing forcing = options.forcing == "modal" ? Forcing::kModal : Forcing::kExcitation;
  const HarmonicBalance balance = balance_of(model, options.prediction, {.forcing = forcing});
  ResponseCurve curve = curve_of(balance, options, responses, mode, call.quiet);
  const std::string truncation = add_truncation(balance, Quantity::kPhaseLag, curve);
  add_model_warnings(model, curve);
  return finish(
      curve, options.prediction, call,
      [&] { return backbone_table(curve, heading_of(call.command_line, model)); },
      [&] {
        return describe_backbone(options.prediction.model, balance, curve, mode) + truncation +
               describe_damping(model) + describe_warnings(curve.warnings);
      });
}

}  // namespace

void add_backbone(CLI::App& program, Call& call) {
  auto options = std::make_shared<BackboneOptions>();
  CLI::App* command = program.add_subcommand(
      "backbone", "Resonance frequency and damping of a structure with joints over the amplitude");
  add_prediction_arguments(*command, options->prediction, call,
                           "displacement [m], force [N], frequency [Hz], damping_ratio [1]");
  command
      ->add_option("--response", options->response,
                   "Amplitudes of the displacement at the response point, FROM:TO:COUNT[:log], in "
                   "m or with units; :log for equal ratios")
      ->required();
  command
      ->add_option("--mode", options->mode,
                   "Whose resonance: number of the mode, by frequency with all joints stuck")
      ->capture_default_str();
  command
      ->add_option(
          "--forcing", options->forcing,
          "What drives: the excitation of the model, or a force at every mass that makes "
          "up what the motion loses there. That is the nonlinear mode itself, whatever the "
          "drive point; the column force is then what would feed as much at the response "
          "point")
      ->check(CLI::IsMember({"excitation", "modal"}))
      ->capture_default_str();
  add_examples(*command,
               {"microslip backbone model.toml --response 10mm:2:40:log --out backbone.csv",
                "microslip backbone model.toml --response 10mm:2:40:log --forcing modal \\",
                "          --out mode.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
