// SPDX-License-Identifier: MIT
#include "microslip/observe/level_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/observe/neighbour_scatter.hpp"

namespace microslip {
namespace {

using Column = std::vector<double>;

/// Below this share of D ∝ A³ through the largest level, a level counts as zero.
constexpr double kFloorShare = 1e-3;
/// A scatter of exactly zero would make weights infinite.
constexpr double kLeastScatter = 1e-9;
/// Fewer levels have no neighbours to scatter about.
constexpr std::size_t kFewestNeighbours = 3;
constexpr double kUnknownScatter = 0.01;

bool all_positive(const Column& values) {
  return !values.empty() && std::ranges::all_of(values, [](double v) { return v > 0.0; });
}

Column floor_of(const Levels& levels) {
  const double largest = std::ranges::max(levels.dissipation);
  Column floor;
  for (const double a : levels.amplitude) {
    floor.push_back(kFloorShare * largest * std::pow(a / levels.amplitude.back(), 3));
  }
  return floor;
}

/// None below the typical relative one at the floor where D is below it: else levels without
/// dissipation would outweigh all others.
Column floored_deviations(const Levels& levels, const Column& floor) {
  Column deviation = levels.dissipation_std;
  Column relative;
  for (std::size_t i = 0; i < floor.size(); ++i) {
    relative.push_back(deviation[i] / std::max(levels.dissipation[i], floor[i]));
  }
  const double typical = median(std::move(relative));
  for (std::size_t i = 0; i < floor.size(); ++i) {
    if (levels.dissipation[i] < floor[i]) deviation[i] = std::max(deviation[i], typical * floor[i]);
  }
  return deviation;
}

/// Scatter of ln D over ln A, with no D below the floor.
double scatter_of_dissipation(const Levels& levels, const Column& floor) {
  if (levels.size() < kFewestNeighbours) return kUnknownScatter;
  Column x;
  Column y;
  for (std::size_t i = 0; i < floor.size(); ++i) {
    x.push_back(std::log(levels.amplitude[i]));
    y.push_back(std::log(std::max(levels.dissipation[i], floor[i])));
  }
  return std::max(kLeastScatter, scatter_about_neighbours(x, y));
}

Column residuals_of(const Column& measured, const Column& predicted, const Column& deviation) {
  Column residual;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    residual.push_back((measured[i] - predicted[i]) / deviation[i]);
  }
  return residual;
}

/// Σ of ln(2πσ²) + r².
double deviance(const Column& residual, const Column& deviation) {
  double sum = 0.0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    sum += std::log(2.0 * std::numbers::pi) + 2.0 * std::log(deviation[i]);
    sum += residual[i] * residual[i];
  }
  return sum;
}

double change_at(const Column& change, std::size_t i) { return change.empty() ? 0.0 : change[i]; }

void check_linear_dissipation(const Levels& levels, const CommonErrors& common) {
  if (common.loss_factor_std == 0.0 || !levels.linear_dissipation.empty()) return;
  throw InputError("loss_factor_std", common.loss_factor_std,
                   "needs the linear loss of the levels, linear_dissipation",
                   "A reduction of recordings gives it.");
}

}  // namespace

LevelEvidence::LevelEvidence(Levels measured, CommonErrors common)
    : measured_(std::move(measured)), common_(common), merged_(sort_and_merge(measured_)) {
  common_.check();
  check_linear_dissipation(measured_, common_);
  floor_ = floor_of(levels());
  if (all_positive(levels().dissipation_std)) {
    dissipation_std_ = floored_deviations(levels(), floor_);
  }
}

bool LevelEvidence::dissipation_std_given() const { return !dissipation_std_.empty(); }

bool LevelEvidence::secant_std_given() const {
  return !levels().secant_stiffness.empty() && all_positive(levels().secant_stiffness_std);
}

bool LevelEvidence::amplitude_std_counts() const {
  return !levels().amplitude_std.empty() && (dissipation_std_given() || secant_std_given());
}

LevelPrediction LevelEvidence::typical() const {
  const Levels& l = levels();
  Column ratio;
  for (std::size_t i = 0; i < size(); ++i) {
    ratio.push_back(l.dissipation[i] / std::pow(l.amplitude[i], 3));
  }
  LevelPrediction typical;
  typical.value.secant_stiffness = l.secant_stiffness;
  for (std::size_t i = 0; i < size(); ++i) {
    const auto from = ratio.begin() + static_cast<std::ptrdiff_t>(i - std::min<std::size_t>(i, 2));
    const auto to = ratio.begin() + static_cast<std::ptrdiff_t>(std::min(size(), i + 3));
    const double d = median({from, to}) * std::pow(l.amplitude[i], 3);
    typical.value.dissipation.push_back(d);
    if (!amplitude_std_counts()) continue;
    typical.change.dissipation.push_back(3.0 * d * l.amplitude_std[i] / l.amplitude[i]);
  }
  return typical;
}

LevelRows LevelEvidence::predict(const Joint& joint, double linear_damping) const {
  LevelRows rows;
  for (const double a : levels().amplitude) {
    rows.dissipation.push_back(dissipation(joint, a) + linear_damping * a * a);
    if (levels().secant_stiffness.empty()) continue;
    rows.secant_stiffness.push_back(microslip::secant_stiffness(joint, a));
  }
  return rows;
}

LevelRows LevelEvidence::amplitude_change(const Joint& joint, double linear_damping) const {
  LevelRows change;
  if (!amplitude_std_counts()) return change;
  for (std::size_t i = 0; i < size(); ++i) {
    const double above = levels().amplitude[i] + levels().amplitude_std[i];
    const double below = std::max(0.0, levels().amplitude[i] - levels().amplitude_std[i]);
    const auto half = [&](const auto& value) {
      return 0.5 * std::abs(value(above) - value(below));
    };
    change.dissipation.push_back(
        half([&](double a) { return dissipation(joint, a) + linear_damping * a * a; }));
    if (levels().secant_stiffness.empty()) continue;
    change.secant_stiffness.push_back(half([&](double a) { return secant_stiffness(joint, a); }));
  }
  return change;
}

LevelScatter LevelEvidence::expected_scatter(double stiffness) const {
  LevelScatter scatter;
  const Levels& l = levels();
  if (!dissipation_std_given()) scatter.dissipation = scatter_of_dissipation(l, floor_);
  if (l.secant_stiffness.empty() || secant_std_given()) return scatter;
  const double found = l.size() < kFewestNeighbours
                           ? kUnknownScatter * stiffness
                           : scatter_about_neighbours(l.amplitude, l.secant_stiffness);
  scatter.secant_stiffness = std::max(kLeastSecantScatter * stiffness, found);
  return scatter;
}

LevelRows LevelEvidence::deviations(const LevelPrediction& prediction,
                                    const LevelScatter& scatter) const {
  LevelRows deviation;
  const auto root_of_count = [&](std::size_t i) {
    return std::sqrt(static_cast<double>(merged_.count[i]));
  };
  for (std::size_t i = 0; i < size(); ++i) {
    const double d = std::max(prediction.value.dissipation[i], floor_[i]);
    const double sigma =
        dissipation_std_given()
            ? std::hypot(dissipation_std_[i], change_at(prediction.change.dissipation, i))
            : d / root_of_count(i);
    deviation.dissipation.push_back(scatter.dissipation * sigma);
  }
  for (std::size_t i = 0; i < prediction.value.secant_stiffness.size(); ++i) {
    const double sigma = secant_std_given()
                             ? std::hypot(levels().secant_stiffness_std[i],
                                          change_at(prediction.change.secant_stiffness, i))
                             : 1.0 / root_of_count(i);
    deviation.secant_stiffness.push_back(scatter.secant_stiffness * sigma);
  }
  return deviation;
}

LevelRows LevelEvidence::measured_deviations(const LevelPrediction& prediction,
                                             const LevelScatter& scatter) const {
  const LevelRows of_means = deviations(prediction, scatter);
  LevelRows single;
  for (const double a : measured_.amplitude) {
    const auto row = static_cast<std::size_t>(std::ranges::lower_bound(levels().amplitude, a) -
                                              levels().amplitude.begin());
    const double root = std::sqrt(static_cast<double>(merged_.count[row]));
    single.dissipation.push_back(root * of_means.dissipation[row]);
    if (of_means.secant_stiffness.empty()) continue;
    single.secant_stiffness.push_back(root * of_means.secant_stiffness[row]);
  }
  return single;
}

LevelRows LevelEvidence::residuals(const LevelRows& prediction, const LevelRows& deviations) const {
  return {residuals_of(levels().dissipation, prediction.dissipation, deviations.dissipation),
          residuals_of(levels().secant_stiffness, prediction.secant_stiffness,
                       deviations.secant_stiffness)};
}

double LevelEvidence::informative_levels(const LevelPrediction& prediction) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double share =
        dissipation_std_given()
            ? levels().dissipation_std[i] / dissipation_std_[i]
            : levels().dissipation[i] / std::max(prediction.value.dissipation[i], floor_[i]);
    sum += std::min(share * share, 1.0);
  }
  return sum;
}

double LevelEvidence::repeat_sum(const LevelRows& deviations) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    // A single level has the deviation of their mean times √n.
    const double variance =
        std::pow(deviations.dissipation[i], 2) * static_cast<double>(merged_.count[i]);
    if (variance > 0.0) sum += merged_.dissipation_spread[i] / variance;
  }
  return sum;
}

double LevelEvidence::repeat_freedom() const {
  return static_cast<double>(measured_.size()) - static_cast<double>(size());
}

double LevelEvidence::log_likelihood(const LevelPrediction& prediction,
                                     const LevelScatter& scatter) const {
  const LevelRows sigma = deviations(prediction, scatter);
  const LevelRows residual = residuals(prediction.value, sigma);
  double sum = deviance(residual.dissipation, sigma.dissipation) +
               deviance(residual.secant_stiffness, sigma.secant_stiffness) + repeat_sum(sigma);
  // The mean of n levels stands for all of them: n − 1 more factors of σ√n, and √n of its own.
  for (std::size_t i = 0; i < size(); ++i) {
    const auto n = static_cast<double>(merged_.count[i]);
    const double variance = std::pow(sigma.dissipation[i], 2) * n;
    sum += (n - 1.0) * std::log(2.0 * std::numbers::pi * variance) + std::log(n);
  }
  return -0.5 * sum;
}

Levels LevelEvidence::simulate(const LevelPrediction& prediction, const LevelScatter& scatter,
                               RandomStream& random) const {
  const LevelRows sigma = deviations({.value = prediction.value}, scatter);
  const CommonErrorDraw common = common_.draw(random);
  Levels repeated = levels();
  for (std::size_t i = 0; i < size(); ++i) {
    const double lost =
        common.loss_factor == 0.0 ? 0.0 : common.loss_factor * levels().linear_dissipation[i];
    const double d =
        prediction.value.dissipation[i] - lost + sigma.dissipation[i] * random.normal();
    repeated.dissipation[i] = std::max(0.0, d) / std::max(common.dissipation_gain, 1e-3);
    const double error = amplitude_std_counts() ? levels().amplitude_std[i] * random.normal() : 0.0;
    repeated.amplitude[i] = std::max(0.5 * levels().amplitude[i], levels().amplitude[i] + error) /
                            common.amplitude_gain;
    if (sigma.secant_stiffness.empty()) continue;
    const double k = prediction.value.secant_stiffness[i];
    repeated.secant_stiffness[i] =
        std::max(0.1 * k, k + sigma.secant_stiffness[i] * random.normal());
  }
  return repeated;
}

}  // namespace microslip
