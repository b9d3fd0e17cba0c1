// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "microslip/base/median.hpp"

namespace microslip {
namespace {

constexpr double kHop = 0.25;  // from centre to centre, of a window's length

/// A length that holds for the decay as it is at a time.
class LengthRule {
 public:
  LengthRule(const DecayTask& task, std::optional<double> noise_variance)
      : task_(task), noise_(noise_variance) {}

  [[nodiscard]] double longest() const {
    return std::max(task_.shortest, (task_.to - task_.from) / 2.0);
  }

  /// The length that the decay of a window requires, `ahead` seconds behind its centre.
  [[nodiscard]] double operator()(const DecayWindow& window, double ahead = 0.0) const {
    constexpr double kGrowth = 2.0;
    const double decay = window.decay;
    // Other modes are stronger than the decay in so short a window.
    if (!(decay > 0.0)) return std::min(longest(), kGrowth * window.length);
    const double amplitude = window.amplitude * std::exp(-decay * ahead);
    const double by_fall = task_.largest_fall / decay;
    // Where the noise is not known yet: more than half of what the fall allows.
    const double by_noise = noise_ ? length_for(decay, amplitude) : 0.6 * by_fall;
    // Half of it: windows down to 0.8 of the length are taken, through which up to four times as
    // much comes.
    const double by_others = length_for_leakage(window.beside, decay, 0.5 * task_.wanted_std,
                                                task_.shortest, std::max(task_.shortest, by_fall));
    const double least = std::min(task_.least_fall / decay, (task_.to - task_.from) / 8.0);
    return std::clamp(std::max({std::min(by_noise, by_fall), by_others, least}), task_.shortest,
                      longest());
  }

 private:
  [[nodiscard]] double length_for(double decay, double amplitude) const {
    const double share = amplitude * decay * task_.wanted_std;
    return std::cbrt(2.0 * kDecayVariance * *noise_ / (task_.rate * share * share));
  }

  const DecayTask& task_;
  std::optional<double> noise_;
};

/// The window about a centre, its length adapted to what it finds.
std::optional<DecayWindow> adapted(const DecayTask& task, const LengthRule& rule, double& centre,
                                   double length) {
  constexpr int kMostTries = 6;
  constexpr double kEnough = 0.8;  // of the length required by the rule
  constexpr double kTooMuch = 1.4;
  constexpr double kGrowth = 1.6;  // where other modes hide the one sought
  std::optional<DecayWindow> best;
  for (int i = 0; i < kMostTries; ++i) {
    const double at = std::max(centre, task.from + length / 2.0);
    if (at + length / 2.0 > task.to) break;
    const auto found = fit_decay_window(task.signal, task.rate, at, length, task.lowest,
                                        task.highest, task.others);
    if (!found && best) break;
    if (!found) {
      length *= kGrowth;
      if (length > rule.longest()) break;
      continue;
    }
    best = found;
    const double wanted = rule(*found);
    if (length >= kEnough * wanted && length <= kTooMuch * wanted) break;
    length = wanted;
  }
  if (best) centre = best->centre;
  return best;
}

double median_noise(const std::vector<DecayWindow>& windows) {
  std::vector<double> all;
  for (const DecayWindow& window : windows) all.push_back(window.noise_variance);
  if (all.empty()) return 0.0;
  return median(std::move(all));
}

bool rises(const DecayWindow& before, const DecayWindow& now, double noise) {
  constexpr double kSure = 4.0;
  const double scatter = std::sqrt(noise * (before.covariance(0, 0) + now.covariance(0, 0)));
  constexpr double kRounding = 1e-6;
  return std::log(now.amplitude / before.amplitude) > kSure * scatter + kRounding;
}

class Walker {
 public:
  Walker(const DecayTask& task, std::optional<double> noise)
      : task_(task), noise_(noise), rule_(task, noise) {}

  DecayWalk run() {
    double length = std::max(task_.shortest, task_.first_length);
    double centre = task_.from + length / 2.0;
    for (;;) {
      walk_.end_time = centre;
      if (std::max(centre, task_.from + length / 2.0) + length / 2.0 > task_.to) break;
      const auto found = adapted(task_, rule_, centre, length);
      if (!take(found)) {
        if (!walk_.windows.empty()) break;
        // Before the first good window: still driven or shaken.
        centre += 0.5 * length;
        continue;
      }
      const DecayWindow& last = walk_.windows.back();
      const double hop = kHop * last.length;
      centre = last.centre + hop;
      length = rule_(last, hop);
    }
    return std::move(walk_);
  }

 private:
  bool take(const std::optional<DecayWindow>& found) {
    const auto end = [&](WalkEnd reason) {
      walk_.end = reason;
      return false;
    };
    if (!found) return end(near_noise() ? WalkEnd::kNoise : WalkEnd::kLost);
    const double noise = noise_.value_or(found->noise_variance);
    const DecayPoint point = decay_point(*found, task_.measured, noise);
    if (!walk_.windows.empty() && rises(walk_.windows.back(), *found, noise)) {
      return end(WalkEnd::kRise);
    }
    if (!(point.damping_std < task_.largest_std * point.damping)) return end(WalkEnd::kNoise);
    walk_.windows.push_back(*found);
    walk_.end = WalkEnd::kRecord;
    return true;
  }

  /// Whether the last window was not far from the end by noise.
  [[nodiscard]] bool near_noise() const {
    constexpr double kNear = 0.2;
    if (walk_.windows.empty()) return false;
    const DecayWindow& last = walk_.windows.back();
    const DecayPoint point =
        decay_point(last, task_.measured, noise_.value_or(last.noise_variance));
    return point.damping_std > kNear * task_.largest_std * point.damping;
  }

  const DecayTask& task_;
  std::optional<double> noise_;
  LengthRule rule_;
  DecayWalk walk_;
};

}  // namespace

DecayPoint decay_point(const DecayWindow& window, const MeasuredMotion& measured,
                       double noise_variance) {
  const int n = measured.derivatives;
  const double omega = window.omega;
  const double pole = std::hypot(omega, window.decay);
  const double c = n - 2 + measured.shape.slope_at(omega);
  // ζω = −q̇/q − 2ω̇/ω = δ + (n − 2 + d ln φ/d ln ω)ω̇/ω
  const double rate = window.decay + c * window.chirp / omega;
  DecayPoint point;
  point.amplitude = window.amplitude / std::pow(pole, n);
  point.omega = omega;
  point.damping = rate / omega;
  point.loss = 2.0 * std::numbers::pi * rate * omega * point.amplitude * point.amplitude;

  // Slopes by (u, δ, ω, α) of ln A, ω, ζ and the loss; of ln(loss) times the loss, as ζ may be near
  // 0.
  const Eigen::Vector4d rate_slope(0.0, 1.0, -c * window.chirp / (omega * omega), c / omega);
  const Eigen::Vector4d omega_slope(0.0, 0.0, 1.0, 0.0);
  const Eigen::Vector4d log_slope(1.0, 0.0, -n / omega, 0.0);
  const Eigen::Vector4d damping_slope = rate_slope / omega - omega_slope * (point.damping / omega);
  const double unit = 2.0 * std::numbers::pi * omega * point.amplitude * point.amplitude;
  const Eigen::Vector4d loss_slope =
      unit * rate_slope + point.loss * (2.0 * log_slope + omega_slope / omega);
  const auto deviation = [&](const Eigen::Vector4d& slope) {
    return std::sqrt(std::max(0.0, noise_variance * slope.dot(window.covariance * slope)));
  };
  point.amplitude_std = point.amplitude * deviation(log_slope);
  point.omega_std = deviation(omega_slope);
  // By the shape, which is that of a model.
  const double by_shape = measured.shape.slope_std_at(omega) * window.chirp / omega;
  point.damping_std = std::hypot(deviation(damping_slope), by_shape / omega);
  point.loss_std = std::hypot(deviation(loss_slope), unit * by_shape);
  return point;
}

DecayWalk walk_along(const DecayTask& task) {
  const DecayWalk first = Walker(task, std::nullopt).run();
  if (first.windows.empty()) return first;
  const double noise = median_noise(first.windows);
  DecayWalk second = Walker(task, noise).run();
  second.noise_variance = noise;
  return second;
}

}  // namespace microslip
