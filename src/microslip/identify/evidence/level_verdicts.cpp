// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/level_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  const double scatter =
      2.0 * rms * std::sqrt((own.transpose() * own * covariance.bottomRightCorner(2, 2)).trace());
  verdict.noise = std::max(kLeastOrder, kOverScatter * scatter);
  verdict.broken = verdict.share > verdict.noise;
  return verdict;
}

LevelDepartureVerdict verdict_of(LevelDeparture departure, const MasingMisfit& misfit,
                                 std::string_view quantity) {
  return {.departure = departure,
          .share = misfit.share,
          .noise = misfit.noise,
          .broken = misfit.failed(),
          .quantity = quantity,
          .misfit = misfit};
}

/// Nothing where σ would hide any departure.
std::optional<LevelDepartureVerdict> judge_secant(const LevelEvidence& levels, double stiffness,
                                                  bool linear_damping) {
  const std::optional<MasingMisfit> misfit = secant_misfit(levels, stiffness, linear_damping);
  if (!misfit || (!misfit->failed() && misfit->noise > kHidden)) return std::nullopt;
  return verdict_of(LevelDeparture::kSecant, *misfit, "k_eq");
}

/// The worst of a rise, a fall and a step: by how much each exceeds its limit.
LevelDepartureVerdict judge_frequency(const LevelEvidence& levels, double stiffness,
                                      bool linear_damping, const FrequencyEvidence& evidence) {
  const auto excess = [](const FrequencyChange& change) { return change.beyond / change.limit; };
  const FrequencyChange& worst =
      excess(evidence.rise) > excess(evidence.fall) ? evidence.rise : evidence.fall;
  const std::optional<MasingMisfit> misfit = frequency_misfit(levels, stiffness, linear_damping);
  if (misfit && misfit->failed() && !evidence.rise.significant && !evidence.fall.significant) {
    return verdict_of(LevelDeparture::kFrequency, *misfit, "frequency");
  }
  return {.departure = LevelDeparture::kFrequency,
          .share = worst.beyond,
          .noise = worst.limit,
          .broken = evidence.rise.significant || evidence.fall.significant,
          .quantity = "frequency"};
}

std::string remedy_of(LevelCause cause) {
  switch (cause) {
    case LevelCause::kStep:
      return "Identify the levels on either side separately, or measure all under one load.";
    case LevelCause::kTrend:
    case LevelCause::kOrder:
      return "Measure under one load: check the bolts, wear and temperature by repeating the first "
             "levels at the end.";
    case LevelCause::kLinearDamping:
      return "Subtract the damping of the structure, or identify it with the joint (linear "
             "damping).";
    case LevelCause::kLossFactor:
      return "Check gains and units of D and k_eq, and the loss factor that was subtracted.";
    case LevelCause::kUnknown:
      break;
  }
  return "Check the levels for backlash, another session and a changed load; if D or k_eq is less "
         "accurate than that, give dissipation_std and secant_stiffness_std, or leave k_eq out.";
}

Warning warning_of(const LevelDepartureVerdict& verdict) {
  const bool secant = verdict.departure == LevelDeparture::kSecant;
  const std::string_view name = secant ? "k_eq" : "the frequency";
  return {secant ? "secant_contradicts" : "frequency_steps",
          fmt::format("not one Masing joint under constant normal load: the best joint misses {} "
                      "with D by {} (rms), where noise gives {} at most, {}. {}",
                      name, percent_text(verdict.share), percent_text(verdict.noise),
                      cause_text(*verdict.misfit, name), remedy_of(verdict.misfit->cause))};
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
                                                std::optional<double> linear_damping,
                                                const StiffnessEvidence& evidence) {
  const double k = joint.stiffness();
  std::vector<LevelDepartureVerdict> verdicts;
  if (const auto order = judge_order(levels, joint, linear_damping.value_or(0.0))) {
    verdicts.push_back(*order);
  }
  if (const auto secant = judge_secant(levels, k, linear_damping.has_value())) {
    verdicts.push_back(*secant);
  }
  if (evidence.frequency) {
    verdicts.push_back(judge_frequency(levels, k, linear_damping.has_value(), *evidence.frequency));
  }
  return verdicts;
}

std::vector<Warning> diagnose(const std::vector<LevelDepartureVerdict>& verdicts) {
  std::vector<Warning> warnings;
  for (const LevelDepartureVerdict& verdict : verdicts) {
    if (!verdict.broken) continue;
    if (verdict.misfit) warnings.push_back(warning_of(verdict));
    if (verdict.departure != LevelDeparture::kOrder) continue;
    warnings.push_back(
        {std::string(to_string(verdict.departure)),
         fmt::format(
             "not a Masing joint under constant normal load: {} of rising levels deviates from "
             "that of falling ones by {}, where noise gives {} at most. Wear, temperature or a "
             "changed load: identify each direction separately, or run the joint in first.",
             verdict.quantity, percent_text(verdict.share), percent_text(verdict.noise))});
  }
  return warnings;
}

}  // namespace microslip
