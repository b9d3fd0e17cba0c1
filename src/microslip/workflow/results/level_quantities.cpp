// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/level_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>

#include "microslip/base/interpolation.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {
namespace {

/// D at the level of a record that the virtual test knows; nothing where it knows none.
std::optional<double> exact_dissipation(const MeasuredLevels& exact, const std::string& source) {
  const auto found = std::ranges::find(exact.source, file_name(source),
                                       [](const auto& one) { return file_name(one); });
  if (found == exact.source.end()) return std::nullopt;
  return exact.levels.dissipation[static_cast<std::size_t>(found - exact.source.begin())];
}

}  // namespace

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
  const LevelEvidence evidence(results.levels->levels);
  if (!evidence.dissipation_std_given()) return {};
  LevelPrediction prediction = evidence.typical();
  if (results.joint) {
    const Joint& joint = results.joint->joint;
    const double beta = results.joint->linear_damping.value_or(0.0);
    prediction = {.value = evidence.predict(joint, beta),
                  .change = evidence.amplitude_change(joint, beta)};
  }
  return evidence.measured_deviations(prediction).dissipation;
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

MeasuredPoints relative_residuals(const ExperimentResults& results) {
  const Levels& levels = results.levels->levels;
  MeasuredPoints residuals{residuals_over(results, levels.dissipation), {}};
  for (std::size_t i = 0; i < levels.dissipation_std.size(); ++i) {
    const double relative = levels.dissipation_std[i] / levels.dissipation[i];
    residuals.std.push_back(std::isfinite(relative) ? relative : 0.0);
  }
  return residuals;
}

std::vector<double> linear_share(const MeasuredLevels& levels) {
  std::vector<double> share;
  for (std::size_t i = 0; i < levels.input_energy.size(); ++i) {
    share.push_back(levels.linear_dissipation[i] / levels.input_energy[i]);
  }
  return share;
}

std::vector<double> measured_damping(const ExperimentResults& results) {
  const JointBackbone& backbone = *results.backbone;
  const MeasuredLevels& test = *results.levels;
  if (backbone.vibration_energy.empty() || test.input_energy.empty()) return {};
  std::vector<double> modal_stiffness;  // over 2: E/A² is nearly constant
  for (std::size_t i = 0; i < backbone.amplitude.size(); ++i) {
    modal_stiffness.push_back(backbone.vibration_energy[i] / std::pow(backbone.amplitude[i], 2));
  }
  std::vector<double> ratio;
  for (std::size_t i = 0; i < test.levels.size(); ++i) {
    const double a = test.levels.amplitude[i];
    const double energy = interpolate(backbone.amplitude, modal_stiffness, a) * a * a;
    ratio.push_back(test.input_energy[i] / (4.0 * std::numbers::pi * energy));
  }
  return ratio;
}

Curve reduction_errors(const MeasuredLevels& levels, const MeasuredLevels& exact) {
  Curve errors;
  for (std::size_t i = 0; i < levels.source.size(); ++i) {
    const std::optional<double> expected = exact_dissipation(exact, levels.source[i]);
    if (!expected) continue;
    errors.x.push_back(levels.levels.amplitude[i]);
    errors.y.push_back(levels.levels.dissipation[i] / *expected - 1.0);
  }
  return errors;
}

std::vector<double> curve_amplitudes(const Levels& levels) {
  const auto [lowest, highest] = std::ranges::minmax(levels.amplitude);
  return equal_ratios(lowest, highest);
}

}  // namespace microslip
