// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_spread.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "microslip/algebra/qr.hpp"

namespace microslip {
namespace {

/// Error of D, by ring_down.hpp: harmonics and terms of the order ζ².
constexpr double kTheory = 0.0015;

double square(double x) { return x * x; }

/// Means over neighbouring windows: one difference alone is a poor estimate of its standard
/// deviation. Differences below the share of the noise carry no information on the windows.
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

/// One quantity in the windows about another: their times over its length, and their values.
struct Course {
  Eigen::VectorXd place;
  Eigen::VectorXd value;
  Eigen::VectorXd noise;  ///< variance of each value
  double own = 0.0;       ///< of the one in the middle

  /// Windows with more noise than the one in the middle weigh less: behind it the decay sinks into
  /// noise, which would pass for a scatter of the windows before.
  [[nodiscard]] Eigen::VectorXd weights() const {
    return noise.unaryExpr([&](double each) { return each > own ? own / each : 1.0; });
  }

  /// Σw(value − fit)² with the best of Σ c_k basis_k.
  [[nodiscard]] double about(const Eigen::MatrixXd& basis) const {
    const Eigen::VectorXd root = weights().cwiseSqrt();
    const Eigen::MatrixXd left = root.asDiagonal() * basis;
    const Eigen::VectorXd right = root.cwiseProduct(value);
    return (right - left * left.colPivHouseholderQr().solve(right)).squaredNorm();
  }

  /// Mean square beyond noise, where a course of so many unknowns leaves `squares`.
  [[nodiscard]] double excess(double squares, int unknowns) const {
    const Eigen::VectorXd weight = weights();
    const auto n = static_cast<double>(value.size());
    const double freedom = (n - static_cast<double>(unknowns)) / n;
    return std::max(0.0, squares / freedom - weight.dot(noise)) / weight.sum();
  }
};

Eigen::MatrixXd powers_of(const Eigen::VectorXd& place, int degree) {
  Eigen::MatrixXd powers(place.size(), degree + 1);
  for (int k = 0; k <= degree; ++k) powers.col(k) = place.array().pow(k);
  return powers;
}

double about_polynomial(const Course& course, int degree) {
  return course.excess(course.about(powers_of(course.place, degree)), degree + 1);
}

/// About the best parabola that does not turn among the windows: over the amplitude a joint's
/// frequency is monotone, and one that goes back and forth is that of a beat.
double about_monotone(const Course& course) {
  const Eigen::MatrixXd powers = powers_of(course.place, 2);
  const Eigen::Vector3d best = powers.colPivHouseholderQr().solve(course.value);
  const double first = course.place.minCoeff();
  const double last = course.place.maxCoeff();
  const auto slope = [&](double at) { return best[1] + 2.0 * best[2] * at; };
  if (slope(first) * slope(last) >= 0.0) return course.excess(course.about(powers), 3);
  double least = course.about(powers_of(course.place, 0));
  for (const double vertex : {first, last}) {
    Eigen::MatrixXd half = powers.leftCols(2);
    half.col(1) = (course.place.array() - vertex).square();
    least = std::min(least, course.about(half));
  }
  // Noise, too, makes the constraint active: of its two unknowns one counts.
  return course.excess(least, 1);
}

/// The windows whose centres are within one window of another's, `fewest` of the nearest at least;
/// nothing where there are not so many.
std::vector<std::size_t> windows_near(std::span<const DecayWindow> windows, std::size_t centre,
                                      std::size_t fewest) {
  const auto apart = [&](std::size_t i) {
    return std::abs(windows[i].centre - windows[centre].centre);
  };
  std::vector<std::size_t> near(windows.size());
  std::iota(near.begin(), near.end(), std::size_t{0});
  if (near.size() < fewest) return {};
  std::ranges::stable_sort(near, std::less{}, apart);
  std::size_t count = fewest;
  while (count < near.size() && apart(near[count]) <= windows[centre].length) ++count;
  near.resize(count);
  return near;
}

/// @param value, deviation  of a point.
template <typename Value, typename Deviation>
Course course_of(std::span<const DecayWindow> windows, std::span<const DecayPoint> points,
                 std::size_t centre, const std::vector<std::size_t>& near, const Value& value,
                 const Deviation& deviation) {
  const auto n = static_cast<Eigen::Index>(near.size());
  Course course{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n),
                square(deviation(points[centre]))};
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t window = near[static_cast<std::size_t>(i)];
    course.place[i] = (windows[window].centre - windows[centre].centre) / windows[centre].length;
    course.value[i] = value(points[window]);
    course.noise[i] = square(deviation(points[window]));
  }
  return course;
}

/// Scatter of the windows beyond their noise about a smooth course: ln ζ about a parabola, ln A,
/// its integral, about a cubic, and ω about a parabola that keeps its direction. At least two
/// windows more than the unknowns are needed, three for A, whose noise would otherwise pass for
/// scatter at the ends.
DecaySpread excess_scatter(std::span<const DecayWindow> windows, std::span<const DecayPoint> points,
                           std::size_t centre) {
  DecaySpread spread;
  if (const auto near = windows_near(windows, centre, 5); !near.empty()) {
    const double omega = points[centre].omega;
    spread.damping =
        about_polynomial(course_of(
                             windows, points, centre, near,
                             [](const DecayPoint& p) { return std::log(std::abs(p.damping)); },
                             [](const DecayPoint& p) { return p.damping_std / p.damping; }),
                         2);
    spread.loss = spread.damping;
    spread.omega = about_monotone(course_of(
        windows, points, centre, near, [&](const DecayPoint& p) { return p.omega / omega - 1.0; },
        [&](const DecayPoint& p) { return p.omega_std / omega; }));
  }
  if (const auto near = windows_near(windows, centre, 7); !near.empty()) {
    spread.amplitude =
        about_polynomial(course_of(
                             windows, points, centre, near,
                             [](const DecayPoint& p) { return std::log(p.amplitude); },
                             [](const DecayPoint& p) { return p.amplitude_std / p.amplitude; }),
                         3);
  }
  return spread;
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
  const DecayPoint point = decay_point(window, task.measured, noise_variance);
  DecaySpread spread;
  double count = 0.0;
  for (const OtherLength& choice : kOtherLengths) {
    const double length = choice.factor * window.length;
    if (window.centre - length / 2.0 < task.from || window.centre + length / 2.0 > task.to)
      continue;
    if (choice.factor > 1.0 && window.decay * length > kTooFar * task.largest_fall) continue;
    const auto other =
        fit_decay_values(task.signal, task.rate, window.centre, length, lowest, highest);
    if (!other) continue;
    const DecayPoint there = decay_point(*other, task.measured, noise_variance);
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
    noisy.push_back(decay_point(window, task.measured, noise_variance));
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
