// SPDX-License-Identifier: MIT
#include "microslip/report/experiment_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

void check_length(const char* name, std::size_t length, std::size_t levels) {
  if (length == 0 || length == levels) return;
  throw InputError(fmt::format("{}.size()", name), fmt::format("{}", length),
                   fmt::format("must be 0 or the {} of the levels", levels));
}

void check_lengths(const MeasuredLevels& test) {
  check_levels(test.levels);
  const std::size_t count = test.levels.size();
  check_length("source", test.source.size(), count);
  check_length("flags", test.flags.size(), count);
  check_length("frequency", test.frequency.size(), count);
  check_length("resonance_frequency", test.resonance_frequency.size(), count);
  check_length("force_amplitude", test.force_amplitude.size(), count);
  check_length("response_amplitude", test.response_amplitude.size(), count);
  check_length("input_energy", test.input_energy.size(), count);
  check_length("linear_dissipation", test.linear_dissipation.size(), count);
  check_length("force_distortion", test.force_distortion.size(), count);
  check_length("damping_ratio", test.damping_ratio.size(), count);
  check_length("left_out", test.left_out.size(), count);
}

void check_same(const std::string& name, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(name + ".size()", fmt::format("{}", length),
                   fmt::format("must be {}, that of what belongs to it", expected));
}

void check_lengths(const IdentifiedJoint& found) {
  check_same("band_lower", found.band_lower.size(), found.band_slip_force.size());
  check_same("band_upper", found.band_upper.size(), found.band_slip_force.size());
}

void check_lengths(const JointBackbone& backbone) {
  const std::size_t count = backbone.amplitude.size();
  check_same("backbone.frequency", backbone.frequency.size(), count);
  check_same("backbone.damping_ratio", backbone.damping_ratio.size(), count);
  if (backbone.vibration_energy.empty()) return;
  check_same("backbone.vibration_energy", backbone.vibration_energy.size(), count);
}

void check_lengths(const LevelRecord& record) {
  for (const SignalPair& signal : record.signals) {
    check_same(signal.name + ".recorded", signal.recorded.size(), signal.time.size());
    check_same(signal.name + ".other", signal.other.size(), signal.other_time.size());
  }
  for (const HarmonicsPair& channel : record.harmonics) {
    if (channel.other.empty()) continue;
    check_same(channel.name + ".other", channel.other.size(), channel.recorded.size());
  }
}

void check_lengths(const ConstantResponse& response) {
  check_same("force", response.force.size(), response.frequency.size());
  check_same("true_force", response.true_force.size(), response.true_frequency.size());
}

void check_lengths(const ExperimentResults& results) {
  if (results.levels) check_lengths(*results.levels);
  if (results.true_levels) check_lengths(*results.true_levels);
  if (results.joint) check_lengths(*results.joint);
  if (results.backbone) check_lengths(*results.backbone);
  if (results.true_backbone) check_lengths(*results.true_backbone);
  for (const LevelRecord& record : results.records) check_lengths(record);
  for (const LevelRecord& record : results.predictions) check_lengths(record);
  for (const ConstantResponse& response : results.responses) check_lengths(response);
  for (const ForceControlLevel& level : results.force_control) {
    check_same("force_control.after", level.after.size(), level.before.size());
  }
}

/// What sections lack goes into a list of its own before the last section; those that lack
/// everything are left out. The summary keeps what it lacks.
std::vector<ReportSection> with_list_of_missing(std::vector<ReportSection> all) {
  const auto is_missing = [](const ReportBlock& block) {
    return std::holds_alternative<ReportMissing>(block);
  };
  ReportSection missing{.title = "Not in this report", .blocks = {}};
  for (auto section = all.begin() + 1; section != all.end(); ++section) {
    std::vector<ReportBlock>& blocks = section->blocks;
    std::ranges::copy_if(blocks, std::back_inserter(missing.blocks), is_missing);
    std::erase_if(blocks, is_missing);
  }
  std::erase_if(all, [](const ReportSection& section) { return section.blocks.empty(); });
  if (!missing.blocks.empty()) all.insert(all.end() - 1, std::move(missing));
  return all;
}

}  // namespace

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

ReportAxis amplitude_axis(bool log) {
  return {.label = "amplitude A", .unit = "µm", .log = log, .log_switch = true};
}

std::vector<ReportTrace> curves_of_joints(const ExperimentResults& results,
                                          const std::function<double(const Joint&, double)>& value,
                                          const std::function<double(double)>& damping) {
  const auto [lowest, highest] = std::ranges::minmax(results.levels->levels.amplitude);
  const std::vector<double> amplitude = equal_ratios(lowest, highest);
  std::vector<ReportTrace> traces;
  const auto add = [&](const char* name, const Joint& joint, double beta, Stroke stroke) {
    ReportTrace trace{.name = name, .x = in_unit(amplitude, kMicrometre), .stroke = stroke};
    for (const double a : amplitude) {
      trace.y.push_back(value(joint, a) + (beta > 0.0 ? beta * damping(a) : 0.0));
    }
    traces.push_back(std::move(trace));
  };
  if (results.joint) {
    const double beta = damping ? results.joint->linear_damping.value_or(0.0) : 0.0;
    add(beta > 0.0 ? "identified joint and linear damping" : kFoundName, results.joint->joint, beta,
        kFound);
  }
  if (results.truth) {
    add("truth", *results.truth, damping ? results.true_linear_damping : 0.0, kTruth);
  }
  return traces;
}

std::vector<double> net_dissipation(const ExperimentResults& results) {
  const Levels& levels = results.levels->levels;
  const double beta = results.joint ? results.joint->linear_damping.value_or(0.0) : 0.0;
  std::vector<double> net = levels.dissipation;
  for (std::size_t i = 0; i < net.size(); ++i) net[i] -= beta * std::pow(levels.amplitude[i], 2);
  return net;
}

MeasuredPoints measured_loss_factor(const ExperimentResults& results) {
  MeasuredPoints measured;
  if (!results.levels || results.levels->levels.secant_stiffness.empty()) return measured;
  const Levels& levels = results.levels->levels;
  const std::vector<double> dissipation = net_dissipation(results);
  const bool has_std = !levels.dissipation_std.empty() && !levels.amplitude_std.empty() &&
                       !levels.secant_stiffness_std.empty();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double a = levels.amplitude[i];
    const double k = levels.secant_stiffness[i];
    const double work = std::numbers::pi * k * a * a;
    measured.value.push_back(dissipation[i] / work);
    if (!has_std) continue;
    const double relative =
        std::hypot(levels.secant_stiffness_std[i] / k, 2.0 * levels.amplitude_std[i] / a);
    measured.std.push_back(
        std::hypot(levels.dissipation_std[i] / work, measured.value.back() * relative));
  }
  return measured;
}

std::vector<double> dissipation_deviations(const ExperimentResults& results) {
  const Levels& levels = results.levels->levels;
  std::vector<double> deviations = levels.dissipation_std;
  if (std::ranges::any_of(deviations, [](double std) { return !(std > 0.0); })) return {};
  if (levels.amplitude_std.empty() || !results.joint) return deviations;
  const double beta = results.joint->linear_damping.value_or(0.0);
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const double a = levels.amplitude[i];
    const double slope = dissipation_slope(results.joint->joint, a) + 2.0 * beta * a;
    deviations[i] = std::hypot(deviations[i], slope * levels.amplitude_std[i]);
  }
  return deviations;
}

std::vector<double> residuals_over(const ExperimentResults& results,
                                   const std::vector<double>& scale) {
  const std::vector<double> net = net_dissipation(results);
  std::vector<double> residual;
  for (std::size_t i = 0; i < net.size(); ++i) {
    const double fit = dissipation(results.joint->joint, results.levels->levels.amplitude[i]);
    residual.push_back((net[i] - fit) / scale[i]);
  }
  return residual;
}

Misfit misfit_of_levels(const ExperimentResults& results) {
  const MeasuredLevels& test = *results.levels;
  const std::vector<double> deviations = dissipation_deviations(results);
  const std::vector<double> residual =
      residuals_over(results, deviations.empty() ? test.levels.dissipation : deviations);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const bool left_out = !test.left_out.empty() && test.left_out[i];
    if (left_out || !std::isfinite(residual[i])) continue;
    sum += residual[i] * residual[i];
    ++count;
  }
  const double mean = count == 0 ? 0.0 : sum / static_cast<double>(count);
  return {.rms = std::sqrt(mean), .in_deviations = !deviations.empty()};
}

ReportTrace at_levels(const ExperimentResults& results, std::string name, std::vector<double> value,
                      std::vector<double> std, int colour) {
  return {.name = std::move(name),
          .kind = TraceKind::kPoints,
          .x = in_unit(results.levels->levels.amplitude, kMicrometre),
          .y = std::move(value),
          .y_std = std::move(std),
          .stroke = {.colour = colour}};
}

ReportDocument experiment_report(ExperimentResults results) {
  check_lengths(results);
  std::optional<MethodComparison> methods;
  try {
    methods = compare_methods(results);
  } catch (const InputError& error) {
    results.warnings.push_back(
        {"no_other_methods",
         fmt::format("The levels were not evaluated again, for comparison: {}", error.what())});
  }
  return {
      .title = results.title,
      .subtitle = results.subtitle,
      .sections = with_list_of_missing(
          {summary_section(results, methods), levels_section(results), signals_section(results),
           energies_section(results), density_section(results, methods),
           loops_section(results, methods), stiffness_section(results), responses_section(results),
           predictions_section(results), rig_section(results), provenance_section(results)})};
}

}  // namespace microslip
