// SPDX-License-Identifier: MIT
#include "microslip/signal/decay_spread.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace microslip {
namespace {

/// Of D, by ring_down.hpp: harmonics and terms of the order ζ².
constexpr double kTheory = 0.0015;

double square(double x) { return x * x; }

/// Means over neighbouring windows: one difference alone says little of its standard deviation.
DecaySpread mean_about(std::span<const DecayWindow> windows, std::span<const DecaySpread> spreads,
                       std::size_t centre) {
  DecaySpread mean;
  double count = 0.0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double apart = std::abs(windows[i].centre - windows[centre].centre);
    constexpr double kRounding = 1.0 + 1e-9;
    if (apart > 0.5 * windows[centre].length * kRounding) continue;
    mean.amplitude += spreads[i].amplitude;
    mean.omega += spreads[i].omega;
    mean.damping += spreads[i].damping;
    mean.loss += spreads[i].loss;
    count += 1.0;
  }
  return {mean.amplitude / count, mean.omega / count, mean.damping / count, mean.loss / count};
}

/// Mean square of what a parabola over the windows whose centres are within one window leaves of a
/// quantity, by degree of freedom; 0 of fewer than five.
template <typename Value>
double scatter_about(std::span<const DecayWindow> windows, std::size_t centre, const Value& value) {
  constexpr Eigen::Index kFewest = 5;
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (std::abs(windows[i].centre - windows[centre].centre) <= windows[centre].length) {
      near.push_back(i);
    }
  }
  const auto n = static_cast<Eigen::Index>(near.size());
  if (n < kFewest) return 0.0;
  Eigen::MatrixXd powers(n, 3);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t window = near[static_cast<std::size_t>(i)];
    const double s = (windows[window].centre - windows[centre].centre) / windows[centre].length;
    powers.row(i) << 1.0, s, s * s;
    values[i] = value(window);
  }
  const Eigen::VectorXd best = powers.colPivHouseholderQr().solve(values);
  return (values - powers * best).squaredNorm() / static_cast<double>(n - 3);
}

/// What damping scatters beyond its noise. (The other quantities run too steep for a parabola.)
DecaySpread excess_scatter(std::span<const DecayWindow> windows, std::span<const DecayPoint> points,
                           std::size_t centre) {
  const double all = scatter_about(
      windows, centre, [&](std::size_t i) { return std::log(std::abs(points[i].damping)); });
  const double noise = square(points[centre].damping_std / points[centre].damping);
  const double excess = std::max(0.0, all - noise);
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
  constexpr double kFactors[] = {0.8, 1.25, 1.6};
  constexpr double kTooFar = 1.1;  // of the largest fall: the envelope's model follows no farther
  const DecayPoint point = decay_point(window, task.derivatives, noise_variance);
  DecaySpread spread;
  double count = 0.0;
  for (const double factor : kFactors) {
    const double length = factor * window.length;
    if (window.centre - length / 2.0 < task.from || window.centre + length / 2.0 > task.to)
      continue;
    if (factor > 1.0 && window.decay * length > kTooFar * task.largest_fall) continue;
    const auto other = fit_decay_window(task.signal, task.rate, window.centre, length, task.lowest,
                                        task.highest, task.others);
    if (!other) continue;
    const DecayPoint there = decay_point(*other, task.derivatives, noise_variance);
    spread.amplitude += square(there.amplitude / point.amplitude - 1.0);
    spread.omega += square(there.omega / point.omega - 1.0);
    spread.damping += square(there.damping / point.damping - 1.0);
    spread.loss += square(there.loss / point.loss - 1.0);
    count += 1.0;
  }
  if (count > 0.0) {
    spread = {spread.amplitude / count, spread.omega / count, spread.damping / count,
              spread.loss / count};
  }
  // The mean square over the phase at which the other mode comes by.
  const double leaked = 0.5 * square(relative_leakage(window));
  spread.damping = std::max(spread.damping, leaked);
  spread.loss = std::max(spread.loss, leaked);
  return spread;
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
