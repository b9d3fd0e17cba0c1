// SPDX-License-Identifier: MIT
#include "microslip/calibrate/level_residuals.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "microslip/identify/posterior/quantiles.hpp"

namespace microslip {
namespace {

/// Mean over the levels of the mode and session of each level of their frequency offsets.
void read_offsets_of_levels(const ModalLevels& levels, const std::vector<double>& errors,
                            CalibrationResult& result) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t j = 0; j < levels.size(); ++j) {
      if (std::isnan(errors[j]) || !levels.same_offset(i, j)) continue;
      sum += errors[j];
      count += 1.0;
    }
    result.levels[i].frequency_offset = sum / count;  // NaN of none
  }
}

/// ω of a level as measured over that of the structure as it was given, minus 1; NaN without.
double error_of_given(const ModalLevels& levels, std::size_t level, const LevelStates& states) {
  const double error = frequency_error(levels, level, *states.at(level));
  return (1.0 + error) * std::exp(states.offset_taken(levels.mode[level])) - 1.0;
}

/// Standard deviation of the loss of all joints at a level: where it was measured in parts, of
/// their sum.
double loss_deviation(const LevelDeviations& deviations) {
  if (!std::isnan(deviations.loss)) return deviations.loss;
  double variance = 0.0;
  for (const double part : deviations.joints) variance += part * part;
  return std::sqrt(variance);
}

/// Residuals over their scatter, and in `change` minus the offset of their mode.
void read_residuals(const CalibrationEvidence& evidence, std::size_t level, double error,
                    const LevelDeviations& deviations, CalibrationResult& result) {
  CalibratedLevel& fitted = result.levels[level];
  fitted.residual = (fitted.measured_dissipation - fitted.dissipation) /
                    (loss_deviation(deviations) * result.loss_scatter);
  if (evidence.frequency == FrequencyUse::kIgnore || std::isnan(error)) return;
  if (evidence.frequency == FrequencyUse::kChange) {
    error -= fitted.frequency_offset;
  }
  fitted.frequency_residual = error / (deviations.frequency * result.frequency_scatter);
}

/// Standard deviation of the loss of a level, J; without the error of its displacement.
double loss_noise(const CalibrationEvidence& evidence, std::size_t level,
                  const SteadyVibration& vibration, const CalibrationResult& result) {
  const CalibratedLevel& fitted = result.levels[level];
  const auto one = [&](double value, double deviation, double scattered) {
    return evidence.loss_std_given ? std::max(1.0, result.loss_scatter) * deviation
                                   : result.loss_scatter * std::max(value, scattered);
  };
  const MeasuredLoss measured = measured_loss(evidence.levels, level, vibration);
  if (!std::isnan(measured.value)) {
    return one(fitted.dissipation, measured.deviation, measured.scattered);
  }
  double variance = 0.0;  // of the parts
  for (std::size_t joint = 0; joint < fitted.joints.size(); ++joint) {
    const std::size_t column = evidence.column[joint];
    if (column == CalibrationEvidence::kNone) continue;
    const JointLevels& levels = evidence.levels.joints[column];
    const double noise = one(fitted.joints[joint].dissipation.value,
                             ModalLevels::value(levels.dissipation_std, level),
                             ModalLevels::value(levels.dissipation, level));
    variance += noise * noise;
  }
  return std::sqrt(variance);
}

/// No draw of a density above 0 has a loss of 0, however little the levels determine it: the band
/// of a loss that is within the error of a level extends to 0. Where one joint may have none, the
/// others may have all, up to the error of the sum.
/// @param sought        joints of the structure that were found, and their losses without slip, J.
/// @param above         by how much the loss of all joints together may exceed the estimate, J.
void open_bands(const std::vector<std::pair<std::size_t, double>>& sought,
                const LevelDeviations& deviations, double above, const CalibrationResult& result,
                CalibratedLevel& fitted) {
  const boost::math::normal standard;
  const double deviations_of_band =
      boost::math::quantile(standard, 0.5 * (1.0 + result.confidence)) * result.loss_scatter;
  bool opened = false;
  for (const auto& [joint, beside] : sought) {
    Estimate& loss = fitted.joints[joint].dissipation;
    const double own = deviations.joints[joint];
    const double error = deviations_of_band * (std::isnan(own) ? deviations.loss : own);
    if (!(loss.lower > beside && loss.lower - beside < error)) continue;
    loss.lower = beside;
    opened = true;
  }
  if (!opened) return;
  double lower = 0.0;
  for (const JointAtLevel& joint : fitted.joints) lower += joint.dissipation.lower;
  for (const auto& [joint, beside] : sought) {
    Estimate& loss = fitted.joints[joint].dissipation;
    loss.upper = std::max(loss.upper, fitted.dissipation + above - (lower - loss.lower));
  }
}

/// Upper end of the band of the loss of all identified joints, above its mean.
/// @param losses  [joint][draw], J.
double above_the_sum(const std::vector<std::vector<double>>& losses, double confidence) {
  std::vector<double> sum(losses.front().size(), 0.0);
  for (const std::vector<double>& of_joint : losses) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += of_joint[i];
  }
  const double mean =
      std::accumulate(sum.begin(), sum.end(), 0.0) / static_cast<double>(sum.size());
  return std::max(0.0, quantile_pair_above_zero(sum, confidence).second - mean);
}

}  // namespace

void read_offsets(const CalibrationEvidence& evidence, const LevelStates& states,
                  CalibrationResult& result) {
  const std::size_t modes = states.structure().linear().vibrations();
  std::vector<double> sum(modes, 0.0);
  std::vector<double> count(modes, 0.0);
  std::vector<double> errors(evidence.levels.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < evidence.levels.size(); ++i) {
    if (!states.at(i)) continue;
    errors[i] = error_of_given(evidence.levels, i, states);
    if (std::isnan(errors[i])) continue;
    sum[evidence.levels.mode[i]] += errors[i];
    count[evidence.levels.mode[i]] += 1.0;
  }
  read_offsets_of_levels(evidence.levels, errors, result);
  for (std::size_t m = 0; m < modes; ++m) {
    result.frequency_offset.push_back(count[m] > 0.0 ? sum[m] / count[m]
                                                     : std::numeric_limits<double>::quiet_NaN());
  }
}

void read_deviations(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                     const LevelStates& states,
                     const std::vector<std::vector<std::vector<double>>>& losses,
                     CalibrationResult& result) {
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (!result.levels[i].found) continue;
    result.levels[i].loss_noise = loss_noise(evidence, i, *states.at(i), result);
    const LevelDeviations deviations = deviations_about(evidence, unknowns, states, i);
    read_residuals(evidence, i, error_of_given(evidence.levels, i, states), deviations, result);
    std::vector<std::pair<std::size_t, double>> sought;
    for (std::size_t j = 0; j < unknowns.count(); ++j) {
      const std::size_t joint = unknowns.index(j);
      const double a = used_amplitude(evidence, states, i, joint);
      sought.emplace_back(joint, states.structure().joints()[joint].linear_damping * a * a);
    }
    open_bands(sought, deviations, above_the_sum(losses[i], result.confidence), result,
               result.levels[i]);
  }
}

}  // namespace microslip
