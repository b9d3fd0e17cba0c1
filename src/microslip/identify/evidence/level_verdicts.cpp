// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/level_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/observe/turning_samples.hpp"

namespace microslip {
namespace {

/// Rising and falling levels differ where that is more than so many times that expected of scatter,
constexpr double kOverScatter = 3.5;
/// and more than this share.
constexpr double kLeastOrder = 0.01;
/// Noise of k_eq above this share of k hides all departures.
constexpr double kHidden = 0.1;
/// Changes of ln A below this count as the same amplitude.
constexpr double kSameAmplitude = 0.05;
constexpr Eigen::Index kFewestOfEach = 4;

/// The levels that lie where both rising and falling ones were measured.
struct Directions {
  std::vector<std::size_t> level;
  std::vector<double> rising;  // 1, or −1 for falling ones
  bool enough = false;
};

/// The direction of each level: rising, 1, or falling, −1.
std::vector<double> rising_of(const std::vector<double>& log_amplitude) {
  std::vector<double> rising(log_amplitude.size(), 1.0);
  const std::vector<std::size_t> turns = turning_samples(log_amplitude, kSameAmplitude);
  for (std::size_t k = 1; k < turns.size(); ++k) {
    const double sign = log_amplitude[turns[k]] > log_amplitude[turns[k - 1]] ? 1.0 : -1.0;
    for (std::size_t i = turns[k - 1] + (k > 1 ? 1 : 0); i <= turns[k]; ++i) rising[i] = sign;
  }
  return rising;
}

Directions directions_of(const std::vector<double>& amplitude) {
  Directions found;
  if (amplitude.size() < 2) return found;
  std::vector<double> log_amplitude;
  for (const double a : amplitude) log_amplitude.push_back(std::log(a));
  const std::vector<double> rising = rising_of(log_amplitude);
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  for (const double sign : {-1.0, 1.0}) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (std::size_t i = 0; i < rising.size(); ++i) {
      if (rising[i] != sign) continue;
      least = std::min(least, amplitude[i]);
      most = std::max(most, amplitude[i]);
    }
    low = std::max(low, least);
    high = std::min(high, most);
  }
  Eigen::Index up = 0;
  Eigen::Index down = 0;
  for (std::size_t i = 0; i < rising.size(); ++i) {
    if (amplitude[i] < low * (1.0 - kSameAmplitude)) continue;
    if (amplitude[i] > high * (1.0 + kSameAmplitude)) continue;
    found.level.push_back(i);
    found.rising.push_back(rising[i]);
    ++(rising[i] > 0.0 ? up : down);
  }
  found.enough = std::min(up, down) >= kFewestOfEach;
  return found;
}

/// Excess of rising over falling levels, of relative residuals with deviations.
LevelDepartureVerdict order_of(const Directions& of, const std::vector<double>& log_amplitude,
                               const Eigen::VectorXd& residual, const Eigen::VectorXd& deviation,
                               std::string_view quantity) {
  const auto n = static_cast<Eigen::Index>(of.level.size());
  Eigen::VectorXd x(n);
  Eigen::VectorXd y(n);
  Eigen::VectorXd weight(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t level = of.level[static_cast<std::size_t>(i)];
    x(i) = log_amplitude[level];
    y(i) = residual(static_cast<Eigen::Index>(level));
    weight(i) = 1.0 / deviation(static_cast<Eigen::Index>(level));
  }
  x.array() -= x.mean();
  const Eigen::Map<const Eigen::VectorXd> rising = view_of(of.rising);
  // Their common part is the misfit of the joint.
  Eigen::MatrixXd columns(n, 5);
  columns << Eigen::VectorXd::Ones(n), x, x.cwiseAbs2(), rising, rising.cwiseProduct(x);
  const Eigen::MatrixXd weighted = weight.asDiagonal() * columns;
  const Eigen::LDLT<Eigen::MatrixXd> normal((weighted.transpose() * weighted).eval());
  const Eigen::VectorXd target = weight.cwiseProduct(y);
  const Eigen::VectorXd solution = normal.solve(weighted.transpose() * target);
  const double freedom = std::max(1.0, static_cast<double>(n) - 5.0);
  const double variance = (target - weighted * solution).squaredNorm() / freedom;
  const Eigen::MatrixXd covariance = variance * normal.solve(Eigen::MatrixXd::Identity(5, 5));
  const Eigen::MatrixXd own = columns.rightCols(2);
  const auto rms = 1.0 / std::sqrt(static_cast<double>(n));
  LevelDepartureVerdict verdict{.departure = LevelDeparture::kOrder, .quantity = quantity};
  // ±1: the difference of the two is twice the coefficient.
  verdict.share = 2.0 * rms * (own * solution.tail(2)).norm();
  verdict.noise =
      2.0 * rms * std::sqrt((own.transpose() * own * covariance.bottomRightCorner(2, 2)).trace());
  verdict.broken = verdict.share > std::max(kLeastOrder, kOverScatter * verdict.noise);
  return verdict;
}

bool has_any(const std::vector<Warning>& warnings, std::initializer_list<std::string_view> codes) {
  return std::ranges::any_of(warnings, [&](const Warning& warning) {
    return std::ranges::find(codes, std::string_view(warning.code)) != codes.end();
  });
}

/// Deviation of k_eq from that of the joint without their means, over k, weighted by 1/σ²; nothing
/// where σ would hide any.
std::optional<LevelDepartureVerdict> judge_secant(const LevelEvidence& levels, const Joint& joint,
                                                  const SecantEvidence& evidence,
                                                  const std::vector<Warning>& warnings) {
  const double k = joint.stiffness();
  const LevelRows predicted = levels.predict(joint);
  const LevelRows sigma = levels.deviations({.value = predicted}, levels.expected_scatter(k));
  double square = 0.0;
  double weights = 0.0;
  const std::size_t n = predicted.secant_stiffness.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double weight = std::pow(k / sigma.secant_stiffness[i], 2);
    const double left =
        levels.levels().secant_stiffness[i] - predicted.secant_stiffness[i] - evidence.offset;
    square += weight * std::pow(left / k, 2);
    weights += weight;
  }
  const double noise = std::sqrt(static_cast<double>(n) / weights);
  const bool broken = has_any(warnings, {"secant_misfit", "secant_contradicts"});
  if (!broken && noise > kHidden) return std::nullopt;
  return LevelDepartureVerdict{.departure = LevelDeparture::kSecant,
                               .share = std::sqrt(square / weights),
                               .noise = noise,
                               .broken = broken,
                               .quantity = "k_eq"};
}

LevelDepartureVerdict judge_frequency(const Levels& levels, const FrequencyEvidence& evidence,
                                      const std::vector<Warning>& warnings) {
  double noise = 0.0;
  for (std::size_t i = 0; i < levels.frequency_std.size(); ++i) {
    noise = std::max(noise, levels.frequency_std[i] / levels.frequency[i]);
  }
  const double unexplained = evidence.fall.explained - evidence.fall.change;
  return {.departure = LevelDeparture::kFrequency,
          .share = std::max({0.0, evidence.rise.change, unexplained}),
          .noise = noise,
          .broken = has_any(warnings, {"frequency_rises", "softening_unexplained"}),
          .quantity = "frequency"};
}

}  // namespace

std::string_view to_string(LevelDeparture departure) {
  switch (departure) {
    case LevelDeparture::kSecant:
      return "secant_against_dissipation";
    case LevelDeparture::kFrequency:
      return "frequency_against_dissipation";
    case LevelDeparture::kOrder:
      break;
  }
  return "order_matters";
}

std::optional<LevelDepartureVerdict> judge_order(const LevelEvidence& levels, const Joint& joint,
                                                 double linear_damping) {
  const Levels& measured = levels.measured();
  const Directions directions = directions_of(measured.amplitude);
  if (!directions.enough) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(measured.size());
  const LevelPrediction prediction{levels.predict(joint, linear_damping),
                                   levels.amplitude_change(joint, linear_damping)};
  const LevelRows sigma =
      levels.measured_deviations(prediction, levels.expected_scatter(joint.stiffness()));
  std::vector<double> log_amplitude;
  Eigen::VectorXd residual(n);
  Eigen::VectorXd deviation(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto level = static_cast<std::size_t>(i);
    const double a = measured.amplitude[level];
    const double d = std::max(dissipation(joint, a) + linear_damping * a * a, 1e-300);
    log_amplitude.push_back(std::log(a));
    residual(i) = measured.dissipation[level] / d - 1.0;
    deviation(i) = sigma.dissipation[level] / d;
  }
  LevelDepartureVerdict worst = order_of(directions, log_amplitude, residual, deviation, "D");
  if (measured.secant_stiffness.empty()) return worst;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto level = static_cast<std::size_t>(i);
    const double k = secant_stiffness(joint, measured.amplitude[level]);
    residual(i) = (measured.secant_stiffness[level] - k) / joint.stiffness();
    deviation(i) = sigma.secant_stiffness[level] / joint.stiffness();
  }
  const LevelDepartureVerdict of_secant =
      order_of(directions, log_amplitude, residual, deviation, "k_eq");
  const bool more = of_secant.broken && (!worst.broken || of_secant.share > worst.share);
  return more ? of_secant : worst;
}

std::vector<LevelDepartureVerdict> judge_levels(const LevelEvidence& levels, const Joint& joint,
                                                double linear_damping,
                                                const StiffnessEvidence& evidence,
                                                const std::vector<Warning>& warnings) {
  std::vector<LevelDepartureVerdict> verdicts;
  if (const auto order = judge_order(levels, joint, linear_damping)) verdicts.push_back(*order);
  if (evidence.secant) {
    const auto secant = judge_secant(levels, joint, *evidence.secant, warnings);
    if (secant) verdicts.push_back(*secant);
  }
  if (evidence.frequency) {
    verdicts.push_back(judge_frequency(levels.measured(), *evidence.frequency, warnings));
  }
  return verdicts;
}

std::vector<Warning> diagnose(const std::vector<LevelDepartureVerdict>& verdicts) {
  std::vector<Warning> warnings;
  for (const LevelDepartureVerdict& verdict : verdicts) {
    if (!verdict.broken || verdict.departure != LevelDeparture::kOrder) continue;
    warnings.push_back(
        {std::string(to_string(verdict.departure)),
         fmt::format(
             "not a Masing joint under constant normal load: {} of rising levels deviates from "
             "that of falling ones by {}, where noise would give {}. Wear, temperature or a "
             "changed load: identify each direction separately, or run the joint in first.",
             verdict.quantity, percent_text(verdict.share), percent_text(verdict.noise))});
  }
  return warnings;
}

}  // namespace microslip
