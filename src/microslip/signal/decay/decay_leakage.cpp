// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_leakage.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

double decay_leakage(std::span<const BesideMode> beside, double length) {
  constexpr double kMainLobe = 3.0;  // lines; nearer the two are one to the taper
  double squares = 0.0;
  for (const BesideMode& other : beside) {
    const double d = std::max(kMainLobe, other.distance * length);
    const double moved = other.ratio * 31.8 / (d * (d * d - 1.0) * (d * d - 4.0));
    squares += moved * moved;
  }
  return std::sqrt(squares);
}

double length_for_leakage(std::span<const BesideMode> beside, double decay, double share,
                          double shortest, double longest) {
  const auto clean = [&](double length) {
    return decay_leakage(beside, length) <= share * decay * length;
  };
  if (clean(shortest)) return shortest;
  if (!clean(longest)) return longest;
  double low = shortest;
  double high = longest;
  while (high > 1.001 * low) {
    const double middle = std::sqrt(low * high);
    (clean(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace microslip
