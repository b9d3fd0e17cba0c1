// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/further_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

constexpr std::size_t kDensityPoints = 40;
constexpr double kNoInformation = 100.0;   // σ over D of a level without information
constexpr double kLeastLevelShare = 1e-4;  // σ over D of any level

/// The scatter that was found, as LevelEvidence takes it.
LevelScatter level_scatter(const LevelEvidence& evidence, const InversionResult& result,
                           double stiffness) {
  LevelScatter scatter = evidence.expected_scatter(stiffness);
  scatter.dissipation = result.dissipation_scatter;
  if (result.secant_scatter) scatter.secant_stiffness = std::max(1.0, *result.secant_scatter);
  return scatter;
}

/// σ of the levels, J and N/m.
LevelRows deviations_of(const LevelEvidence& evidence, const InversionResult& result,
                        double stiffness) {
  const LevelPrediction fitted{{result.fitted_dissipation, result.fitted_secant_stiffness}, {}};
  LevelRows deviation = evidence.deviations(fitted, level_scatter(evidence, result, stiffness));
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const double least = kLeastLevelShare * result.fitted_dissipation[i];
    deviation.dissipation[i] = std::hypot(deviation.dissipation[i], least);
  }
  return deviation;
}

/// Deviations of single levels: one merged from n has √n times as much.
void undo_merging(const LevelEvidence& evidence, LevelRows& deviation) {
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const double root = std::sqrt(static_cast<double>(evidence.merged().count[i]));
    deviation.dissipation[i] *= root;
    if (!deviation.secant_stiffness.empty()) deviation.secant_stiffness[i] *= root;
  }
}

std::vector<double> logarithms(std::vector<double> values) {
  for (double& value : values) value = std::log(value);
  return values;
}

/// k_eq of the levels less their mean weighted by 1/σ².
class SecantMean {
 public:
  SecantMean(const std::vector<double>& amplitude, const std::vector<double>& deviation)
      : amplitude_(amplitude) {
    double sum = 0.0;
    for (const double sigma : deviation) sum += 1.0 / (sigma * sigma);
    for (const double sigma : deviation) weight_.push_back(1.0 / (sigma * sigma) / sum);
    deviation_ = 1.0 / std::sqrt(sum);
  }

  [[nodiscard]] double deviation() const { return deviation_; }
  [[nodiscard]] double of(const Joint& joint) const {
    double mean = 0.0;
    for (std::size_t i = 0; i < weight_.size(); ++i) {
      mean += weight_[i] * secant_stiffness(joint, amplitude_[i]);
    }
    return mean;
  }

 private:
  const std::vector<double>& amplitude_;
  std::vector<double> weight_;
  double deviation_ = 0.0;
};

void add_secant(const LevelEvidence& evidence, std::span<const Joint> joints,
                const std::vector<double>& deviation, const std::vector<double>& single,
                FurtherLevels& further) {
  const SecantMean mean(evidence.levels().amplitude, deviation);
  const std::vector<double> at = logarithms(evidence.levels().amplitude);
  further.secant_offset_std = mean.deviation();
  further.secant_stiffness.columns = further.amplitude.size();
  for (const Joint& joint : joints) {
    const double offset = mean.of(joint);
    for (const double a : further.amplitude) {
      further.secant_stiffness.values.push_back(secant_stiffness(joint, a) - offset);
    }
  }
  for (const double a : further.amplitude) {
    further.secant_stiffness_std.push_back(interpolate(at, single, std::log(a)));
  }
}

}  // namespace

LevelEvidence reaching_to(const LevelEvidence& evidence, const InversionResult& result,
                          double stiffness, double amplitude) {
  Levels levels = evidence.levels();
  if (!(amplitude > levels.amplitude.back())) {
    throw InputError("amplitude to reach", amplitude, "must be above those of the levels");
  }
  const LevelRows deviation = deviations_of(evidence, result, stiffness);
  const Joint joint = joint_of(result, stiffness);
  levels.amplitude.push_back(amplitude);
  levels.dissipation.push_back(dissipation(joint, amplitude));
  levels.dissipation_std = deviation.dissipation;
  levels.dissipation_std.push_back(kNoInformation * levels.dissipation.back());
  if (!levels.amplitude_std.empty()) levels.amplitude_std.assign(levels.amplitude.size(), 0.0);
  if (!levels.secant_stiffness.empty()) {
    levels.secant_stiffness.push_back(levels.secant_stiffness.back());
    levels.secant_stiffness_std = deviation.secant_stiffness;
    levels.secant_stiffness_std.push_back(kNoInformation * stiffness);
  }
  levels.linear_dissipation.clear();
  levels.frequency.clear();
  levels.frequency_std.clear();
  return LevelEvidence(std::move(levels));
}

FurtherLevels further_levels(const LevelEvidence& evidence, const InversionResult& result,
                             std::span<const Joint> joints, const std::vector<double>& amplitude) {
  if (joints.empty()) throw InputError("draws", "none", "must be given to plan levels");
  const LevelRows deviation = deviations_of(evidence, result, joints.front().stiffness());
  LevelRows single = deviation;
  undo_merging(evidence, single);
  const std::vector<double> at = logarithms(evidence.levels().amplitude);
  std::vector<double> share = single.dissipation;
  for (std::size_t i = 0; i < share.size(); ++i) {
    share[i] /= std::max(result.fitted_dissipation[i], evidence.dissipation_floor()[i]);
  }
  FurtherLevels further;
  further.amplitude = amplitude;
  further.dissipation.columns = amplitude.size();
  std::vector<double> mean(amplitude.size());
  for (const Joint& joint : joints) {
    for (std::size_t c = 0; c < amplitude.size(); ++c) {
      const double d = dissipation(joint, amplitude[c]);
      further.dissipation.values.push_back(d);
      mean[c] += d / static_cast<double>(joints.size());
    }
  }
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    further.dissipation_std.push_back(interpolate(at, share, std::log(amplitude[c])) * mean[c]);
  }
  if (!deviation.secant_stiffness.empty()) {
    add_secant(evidence, joints, deviation.secant_stiffness, single.secant_stiffness, further);
  }
  return further;
}

DesignTarget density_target(std::span<const Joint> joints, std::pair<double, double> range) {
  DesignTarget target;
  target.draws.columns = kDensityPoints;
  target.weight.assign(kDensityPoints, 1.0 / kDensityPoints);
  for (const Joint& joint : joints) {
    for (std::size_t i = 0; i < kDensityPoints; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / kDensityPoints;
      target.draws.values.push_back(
          joint.density().density(range.first + share * (range.second - range.first)));
    }
  }
  return target;
}

DesignTarget area_target(std::span<const Joint> joints, std::pair<double, double> range) {
  DesignTarget target;
  target.draws.columns = 1;
  target.weight = {1.0};
  for (const Joint& joint : joints) {
    target.draws.values.push_back(joint.density().moments(range.second).zeroth -
                                  joint.density().moments(range.first).zeroth);
  }
  return target;
}

}  // namespace microslip
