// SPDX-License-Identifier: MIT
#include "microslip/dynamics/cycle_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/dynamics/bracketed_newton.hpp"
#include "microslip/dynamics/trigonometric_basis.hpp"

namespace microslip {
namespace {

/// The extreme between two angles: a maximum for sign = 1, a minimum for −1.
double turning_angle(std::span<const double> coefficients, double low, double high, double sign) {
  const auto descent = [&](double tau) {
    const Motion motion = motion_at(coefficients, tau);
    return Growing{-sign * motion.velocity, -sign * motion.acceleration};
  };
  return growing_zero(descent, low, high);
}

}  // namespace

void CycleExtremes::find(std::span<const double> x, std::span<const double> coefficients) {
  extremes_.clear();
  const std::size_t n = x.size();
  const double step = 2.0 * std::numbers::pi / static_cast<double>(n);
  // The direction in which the first sample is reached; equal samples go on as before.
  double direction = 0.0;
  for (std::size_t k = n; k-- > 0 && direction == 0.0;) direction = x[(k + 1) % n] - x[k];
  if (direction == 0.0) return;
  for (std::size_t k = 0; k < n; ++k) {
    const double ahead = x[k + 1 < n ? k + 1 : 0] - x[k];
    if (!(ahead * direction < 0.0)) {
      if (ahead != 0.0) direction = ahead;
      continue;
    }
    const double sign = direction > 0.0 ? 1.0 : -1.0;
    direction = ahead;
    const double here = step * static_cast<double>(k);
    const bool later = sign * motion_at(coefficients, here).velocity > 0.0;
    const double tau = later ? turning_angle(coefficients, here, here + step, sign)
                             : turning_angle(coefficients, here - step, here, sign);
    const double value = motion_at(coefficients, tau).value;
    extremes_.push_back({tau, sign * std::max(sign * value, sign * x[k]),
                         static_cast<Eigen::Index>(later ? (k + 1) % n : k)});
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
