// SPDX-License-Identifier: MIT
#include "prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/damping_twice.hpp"
#include "microslip/dynamics/truncation.hpp"
#include "microslip/identify/covered_range.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/response_file.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "report_text.hpp"

namespace microslip::app {
namespace {

constexpr std::uint64_t kMostHarmonics = 1000;
constexpr std::uint64_t kMostSamples = 1'000'000;

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// What is used and what was identified, which are not the same where the model says so. Empty
/// where there is neither.
std::string damping_of(const ModelFile& model, std::size_t j) {
  const double used = model.structure.joints()[j].linear_damping;
  double identified = 0.0;
  if (j < model.identified_damping.size()) identified = model.identified_damping[j].value_or(0.0);
  if (used == 0.0 && identified == 0.0) return "";
  if (used == identified) return damping_text(used) + ", as identified";
  if (identified == 0.0) return damping_text(used) + ", as the model says";
  return fmt::format("{}, as the model says; identified are {:.6g} J/m^2",
                     used == 0.0 ? "none" : damping_text(used), identified);
}

}  // namespace

void add_prediction_arguments(CLI::App& command, PredictionArguments& arguments, Call& call,
                              const std::string& columns) {
  command.add_option("model", arguments.model, "Structure with joints, model.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      .add_option("--out", arguments.out,
                  "CSV to write: " + columns +
                      ", energies, amplitude and dissipation of each joint; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command
      .add_option("--harmonics", arguments.harmonics,
                  "H: the motion has harmonics 0 to H. 3 serve where a joint hardly slips, 9 in "
                  "macro-slip")
      ->capture_default_str();
  command
      .add_option("--samples", arguments.samples,
                  "Samples of a cycle for the forces of the joints, 2H + 2 or more")
      ->capture_default_str();
  command.add_flag("--quiet", call.quiet, "No summary, no progress");
}

HarmonicBalance balance_of(const ModelFile& model, const PredictionArguments& arguments,
                           HarmonicBalanceOptions options) {
  options.harmonics = parse_whole_number("--harmonics", arguments.harmonics, 1, kMostHarmonics);
  options.samples = parse_whole_number("--samples", arguments.samples, 4, kMostSamples);
  try {
    return HarmonicBalance(model.structure, {model.response}, std::move(options));
  } catch (const InputError& error) {
    const bool option = error.name() == "harmonics" || error.name() == "samples";
    throw error.renamed(option ? "--" + error.name()
                               : fmt::format("{}: {}", input_name(arguments.model), error.name()));
  }
}

double parse_force(std::string_view option, std::string_view text) {
  const double force = parse_quantity(option, text, kForce);
  if (force >= 1e-12 && force <= 1e12) return force;
  throw InputError(option, force, "must be above 0 N: from 1e-12 to 1e12");
}

std::string heading_of(const Call& call, const ModelFile& model) {
  std::string text = microslip::heading_of(call.command_line);
  for (std::size_t j = 0; j < model.structure.joints().size(); ++j) {
    const std::string damping = damping_of(model, j);
    if (damping.empty()) continue;
    text += fmt::format("\nlinear damping of '{}': {}", model.structure.joints()[j].name, damping);
  }
  return text;
}

std::string damping_text(double linear_damping) {
  if (linear_damping == 0.0) return "";
  return fmt::format("{:.6g} J/m^2 beside slip", linear_damping);
}

std::string stuck_frequencies_text(const JointedStructure& structure) {
  constexpr std::size_t kMost = 5;
  const std::vector<double> omega = structure.stuck_frequencies();
  std::string text;
  for (std::size_t i = 0; i < std::min(omega.size(), kMost); ++i) {
    text += fmt::format("{}{:.5g}", i == 0 ? "" : ", ", omega[i] / (2.0 * std::numbers::pi));
  }
  return text + (omega.size() > kMost ? ", ... Hz" : " Hz");
}

std::string describe_model(const std::string& file, const JointedStructure& structure) {
  return line("model", fmt::format("{}, {}, {}", input_name(file),
                                   counted(structure.linear().size(), "mode"),
                                   counted(structure.joints().size(), "joint"))) +
         line("stuck resonances", stuck_frequencies_text(structure));
}

std::string describe_damping(const ModelFile& model) {
  std::string text;
  for (std::size_t j = 0; j < model.structure.joints().size(); ++j) {
    const std::string damping = damping_of(model, j);
    if (damping.empty()) continue;
    text +=
        line("linear damping", fmt::format("'{}': {}", model.structure.joints()[j].name, damping));
  }
  return text;
}

std::vector<Warning> reach_warnings(const ModelFile& model, const std::vector<double>& amplitude) {
  std::vector<Warning> warnings;
  for (std::size_t j = 0; j < std::min(amplitude.size(), model.covered_to.size()); ++j) {
    const StructuralJoint& joint = model.structure.joints()[j];
    auto warning = beyond_identification(joint.joint, amplitude[j], model.covered_to[j]);
    if (!warning) continue;
    warning->text = fmt::format("'{}': {}", joint.name, warning->text);
    warnings.push_back(std::move(*warning));
  }
  return warnings;
}

void add_model_warnings(const ModelFile& model, ResponseCurve& curve) {
  std::ranges::copy(damping_twice(model.structure), std::back_inserter(curve.warnings));
  std::vector<double> amplitude(model.structure.joints().size(), 0.0);
  for (const SteadyVibration& point : curve.points) {
    for (std::size_t j = 0; j < amplitude.size(); ++j) {
      amplitude[j] = std::max(amplitude[j], point.joints[j].amplitude);
    }
  }
  std::ranges::copy(reach_warnings(model, amplitude), std::back_inserter(curve.warnings));
}

std::string add_truncation(const HarmonicBalance& balance, Quantity kept, ResponseCurve& curve) {
  const std::optional<Truncation> truncation = judge_truncation(balance, curve, kept);
  if (!truncation) return "";
  if (auto warning = truncation_warning(*truncation)) {
    if (warning->code == "truncated") {
      warning->text += fmt::format(" (--harmonics {})", truncation->harmonics);
    }
    curve.warnings.push_back(std::move(*warning));
  }
  if (truncation->points == 0) return "";
  const std::string left_out =
      truncation->peaks_left_out == 0
          ? ""
          : fmt::format(", {} not", counted(truncation->peaks_left_out, "peak"));
  return line("harmonics above", fmt::format("up to {}: {:.2g} % of a dissipation, {:.2g} % of the "
                                             "level, {} looked at{}",
                                             truncation->harmonics, 100.0 * truncation->dissipation,
                                             100.0 * truncation->level,
                                             counted(truncation->points, "point"), left_out));
}

std::string describe_warnings(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += wrapped("  warning: ", warning.text, 11);
  return text;
}

std::vector<Warning> reach_warnings(const JointFile& file, double amplitude) {
  const auto warning = beyond_identification(file.joint, amplitude, covered_to(file));
  return warning ? std::vector<Warning>{*warning} : std::vector<Warning>{};
}

std::string describe_ending(const Summary& summary) {
  return wrapped(fmt::format("  {:<20} ", "ended"),
                 fmt::format("{}{}", summary.converged() ? "" : "NOT CONVERGED: ", summary.reason),
                 23);
}

std::string describe_curve(const HarmonicBalance& balance, const ResponseCurve& curve,
                           const PredictionArguments& arguments) {
  std::string text = describe_model(arguments.model, balance.structure());
  text += line("method", fmt::format("{}, {}, {}", curve.summary.method,
                                     counted(balance.options().harmonics, "harmonic"),
                                     counted(balance.options().samples, "sample")));
  return text + describe_ending(curve.summary);
}

int tell_ending(const Summary& ended, bool found, const ModelArguments& arguments, const Call& call,
                const std::function<std::string()>& summary) {
  const bool converged = ended.converged();
  if (found && !call.quiet) {
    fmt::print(arguments.out == "-" ? stderr : stdout, "{}", summary());
  } else if (!converged) {
    fmt::print(stderr, "microslip: {}: not converged: {}; {}\n", input_name(arguments.model),
               ended.reason, found ? "what was found is written and marked" : "nothing is written");
  }
  return converged ? kDone : kNotConverged;
}

int finish(const Summary& ended, bool found, const ModelArguments& arguments, const Call& call,
           const std::function<CsvWriter()>& table, const std::function<std::string()>& summary) {
  if (found) write_file(arguments.out, table().str());
  return tell_ending(ended, found, arguments, call, summary);
}

int finish(const ResponseCurve& curve, const PredictionArguments& arguments, const Call& call,
           const std::function<CsvWriter()>& table, const std::function<std::string()>& summary) {
  return finish(curve.summary, has_rows(curve), arguments, call, table, summary);
}

}  // namespace microslip::app
