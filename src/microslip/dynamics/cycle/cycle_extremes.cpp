// SPDX-License-Identifier: MIT
#include "microslip/dynamics/cycle/cycle_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/dynamics/structure/bracketed_newton.hpp"

namespace microslip {
namespace {

struct TurningPoint {
  double tau;
  bool later;  // than the sample
  Motion motion;
};

/// The extreme next to a sample: a maximum for sign = 1, a minimum for −1. What Newton's method
/// evaluated last is the motion there, as the velocity is 0.
TurningPoint turning_point(std::span<const double> coefficients, Wave wave, double here,
                           double step, double sign) {
  Motion motion = motion_at(coefficients, here, wave);
  const bool later = sign * motion.velocity > 0.0;
  const double low = later ? here : here - step;
  const double high = low + step;
  const double near = here - motion.velocity / motion.acceleration;
  const auto descent = [&](double tau) {
    motion = motion_at(coefficients, tau, wave);
    return Growing{-sign * motion.velocity, -sign * motion.acceleration};
  };
  const double tau = growing_zero_near(descent, near, low, high);
  return {tau, later, motion};
}

}  // namespace

void CycleExtremes::find(std::span<const double> x, std::span<const double> coefficients,
                         Wave wave) {
  extremes_.clear();
  const std::size_t n = x.size();
  const double step = 2.0 * std::numbers::pi / static_cast<double>(n);
  // The direction in which the first sample is reached; equal samples keep it.
  double direction = 0.0;
  for (std::size_t k = n; k-- > 0 && direction == 0.0;) direction = x[(k + 1) % n] - x[k];
  if (direction == 0.0) return;
  const std::size_t looked_at = wave == Wave::kOdd ? n / 2 : n;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const double ahead = x[k + 1 < n ? k + 1 : 0] - x[k];
    if (!(ahead * direction < 0.0)) {
      if (ahead != 0.0) direction = ahead;
      continue;
    }
    const double sign = direction > 0.0 ? 1.0 : -1.0;
    direction = ahead;
    const TurningPoint turn =
        turning_point(coefficients, wave, step * static_cast<double>(k), step, sign);
    extremes_.push_back({turn.tau, sign * std::max(sign * turn.motion.value, sign * x[k]),
                         turn.motion.acceleration,
                         static_cast<Eigen::Index>(turn.later ? (k + 1) % n : k)});
  }
  if (wave == Wave::kOdd) add_opposite(n);
}

/// Half a period later.
void CycleExtremes::add_opposite(std::size_t samples) {
  const auto count = static_cast<Eigen::Index>(samples);
  const std::size_t half = extremes_.size();
  for (std::size_t i = 0; i < half; ++i) {
    const Extreme& e = extremes_[i];
    extremes_.push_back(
        {e.tau + std::numbers::pi, -e.displacement, -e.acceleration, (e.next + count / 2) % count});
  }
}

std::size_t CycleExtremes::largest() const {
  const auto found = std::ranges::max_element(
      extremes_, {}, [](const Extreme& e) { return std::abs(e.displacement); });
  return static_cast<std::size_t>(found - extremes_.begin());
}

double CycleExtremes::lowest() const {
  return std::ranges::min(extremes_, {}, &Extreme::displacement).displacement;
}

double CycleExtremes::highest() const {
  return std::ranges::max(extremes_, {}, &Extreme::displacement).displacement;
}

}  // namespace microslip
