// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace microslip {

/// The value of a function, of an angle or a share of a step, and its derivative.
struct Growing {
  double value;
  double slope;
};

/// The root of a function that grows from below 0 at `low` to above 0 at `high`: Newton's method,
/// with a bisection wherever it would leave the remaining interval. Internal to dynamics.
/// @param function  place → Growing. @param first  tried first. @param within  how near to it.
template <typename Function>
[[nodiscard]] double growing_zero_near(const Function& function, double first, double low,
                                       double high, double within = 1e-10) {
  constexpr int kMostSteps = 60;
  double tau = first > low && first < high ? first : 0.5 * (low + high);
  for (int step = 0; step < kMostSteps && high - low > within; ++step) {
    const Growing at = function(tau);
    (at.value < 0.0 ? low : high) = tau;
    double next = tau - at.value / at.slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double moved = std::abs(next - tau);
    tau = next;
    if (moved < within) break;
  }
  return tau;
}

/// The root from a start in the middle.
template <typename Function>
[[nodiscard]] double growing_zero(const Function& function, double low, double high,
                                  double within = 1e-10) {
  return growing_zero_near(function, 0.5 * (low + high), low, high, within);
}

}  // namespace microslip
