// SPDX-License-Identifier: MIT
#include "microslip/signal/decay_spread.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace microslip {
namespace {

/// Of D, by ring_down.hpp: harmonics and terms of the order ζ².
constexpr double kTheory = 0.0015;

double square(double x) { return x * x; }

/// A length that a window is fitted with again, and what noise alone makes the two differ by: mean
/// squares over the variance of the one. For estimators b_T of the fit, under cos⁴ and few radians of
/// decay, Σ(b_T − b_T′)²/Σb_T²; the lengths share samples, and it is less than the variances differ by.
struct OtherLength {
  double factor;
  double level;      ///< of u, with the curvature of the envelope free
  double frequency;  ///< of ω, with β free
  double decay;      ///< of δ
};
constexpr OtherLength kOtherLengths[] = {
    {0.8, 0.062, 0.340, 0.284}, {1.25, 0.050, 0.174, 0.145}, {1.6, 0.179, 0.492, 0.430}};

/// Means over neighbouring windows: one difference alone says little of its standard deviation. What
/// is below the share of the noise says nothing of the windows.
DecaySpread mean_about(std::span<const DecayWindow> windows, std::span<const DecaySpread> spreads,
                       std::size_t centre) {
  DecaySpread mean;
  double leaked = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double apart = std::abs(windows[i].centre - windows[centre].centre);
    constexpr double kRounding = 1.0 + 1e-9;
    if (apart > 0.5 * windows[centre].length * kRounding) continue;
    mean.amplitude += spreads[i].amplitude;
    mean.omega += spreads[i].omega;
    mean.damping += spreads[i].damping;
    mean.loss += spreads[i].loss;
    // The mean square over the phase at which the other mode comes by.
    leaked += 0.5 * square(relative_leakage(windows[i]));
    count += 1.0;
  }
  return {std::max(0.0, mean.amplitude / count), std::max(0.0, mean.omega / count),
          std::max(leaked, mean.damping) / count, std::max(leaked, mean.loss) / count};
}

/// What ln ζ scatters, beyond its noise, about a parabola over the windows whose centres are within one
/// window; 0 of fewer than five. (The other quantities run too steep for a parabola.) Windows with more
/// noise than the one in the middle weigh less: behind it the decay sinks into noise, which would
/// pass for a scatter of the windows before.
DecaySpread excess_scatter(std::span<const DecayWindow> windows, std::span<const DecayPoint> points,
                           std::size_t centre) {
  constexpr Eigen::Index kFewest = 5;
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (std::abs(windows[i].centre - windows[centre].centre) <= windows[centre].length) {
      near.push_back(i);
    }
  }
  const auto n = static_cast<Eigen::Index>(near.size());
  if (n < kFewest) return {};
  const auto noise = [&](std::size_t i) {
    return square(points[i].damping_std / points[i].damping);
  };
  const double own = noise(centre);
  Eigen::MatrixXd powers(n, 3);
  Eigen::VectorXd values(n);
  double weights = 0.0;
  double by_noise = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t window = near[static_cast<std::size_t>(i)];
    const double s = (windows[window].centre - windows[centre].centre) / windows[centre].length;
    const double weight = own > 0.0 ? std::min(1.0, own / noise(window)) : 1.0;
    powers.row(i) << 1.0, s, s * s;
    powers.row(i) *= std::sqrt(weight);
    values[i] = std::sqrt(weight) * std::log(std::abs(points[window].damping));
    weights += weight;
    by_noise += weight * noise(window);
  }
  const Eigen::VectorXd best = powers.colPivHouseholderQr().solve(values);
  const double freedom = static_cast<double>(n - 3) / static_cast<double>(n);
  const double all = (values - powers * best).squaredNorm() / freedom;
  const double excess = std::max(0.0, all - by_noise) / weights;
  return {0.0, 0.0, excess, excess};
}

void widen(DecayPoint& point, const DecaySpread& spread) {
  const auto with = [](double deviation, double value, double relative) {
    return std::sqrt(square(deviation) + square(value) * relative);
  };
  point.amplitude_std = with(point.amplitude_std, point.amplitude, spread.amplitude);
  point.omega_std = with(point.omega_std, point.omega, spread.omega);
  point.damping_std = with(point.damping_std, point.damping, spread.damping);
  point.loss_std = with(point.loss_std, point.loss, spread.loss);
}

}  // namespace

DecaySpread spread_of(const DecayTask& task, const DecayWindow& window, double noise_variance) {
  constexpr double kTooFar = 1.1;  // of the largest fall: the envelope's model follows no farther
  // The mode is known by now: about its frequency the search is short.
  constexpr double kLinesAbout = 3.0;
  const double mode = window.omega / (2.0 * std::numbers::pi);
  const double lowest = std::max(task.lowest, mode - kLinesAbout / window.length);
  const double highest = std::min(task.highest, mode + kLinesAbout / window.length);
  const DecayPoint point = decay_point(window, task.derivatives, noise_variance);
  DecaySpread spread;
  double count = 0.0;
  for (const OtherLength& choice : kOtherLengths) {
    const double length = choice.factor * window.length;
    if (window.centre - length / 2.0 < task.from || window.centre + length / 2.0 > task.to)
      continue;
    if (choice.factor > 1.0 && window.decay * length > kTooFar * task.largest_fall) continue;
    const auto other =
        fit_decay_window(task.signal, task.rate, window.centre, length, lowest, highest, {});
    if (!other) continue;
    const DecayPoint there = decay_point(*other, task.derivatives, noise_variance);
    const auto beyond = [](double a, double b, double deviation, double share) {
      return square(b / a - 1.0) - share * square(deviation / a);
    };
    spread.amplitude += beyond(point.amplitude, there.amplitude, point.amplitude_std, choice.level);
    spread.omega += beyond(point.omega, there.omega, point.omega_std, choice.frequency);
    spread.damping += beyond(point.damping, there.damping, point.damping_std, choice.decay);
    spread.loss += beyond(point.loss, there.loss, point.loss_std, choice.decay);
    count += 1.0;
  }
  if (count == 0.0) return {};
  return {spread.amplitude / count, spread.omega / count, spread.damping / count,
          spread.loss / count};
}

std::vector<DecayPoint> points_of(const DecayTask& task, std::span<const DecayWindow> windows,
                                  double noise_variance) {
  std::vector<DecaySpread> spreads;
  spreads.reserve(windows.size());
  for (const DecayWindow& window : windows) {
    spreads.push_back(spread_of(task, window, noise_variance));
  }
  std::vector<DecayPoint> noisy;
  noisy.reserve(windows.size());
  for (const DecayWindow& window : windows) {
    noisy.push_back(decay_point(window, task.derivatives, noise_variance));
  }
  std::vector<DecayPoint> points = noisy;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    widen(points[i], mean_about(windows, spreads, i));
    widen(points[i], excess_scatter(windows, noisy, i));
    widen(points[i], {.loss = square(kTheory)});
  }
  return points;
}

}  // namespace microslip
