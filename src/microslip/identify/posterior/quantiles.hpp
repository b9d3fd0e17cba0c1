// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace microslip {

/// The value below which a share of draws lies; straight between neighbouring draws.
/// @param sorted  not empty. @param share  in [0, 1].
[[nodiscard]] inline double quantile(const std::vector<double>& sorted, double share) {
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(position);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (position - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

/// The two quantiles between which a share of draws lies, as much below as above.
/// @param values      not empty; sorted afterwards.
/// @param confidence  in (0, 1).
[[nodiscard]] inline std::pair<double, double> quantile_pair(std::vector<double>& values,
                                                             double confidence) {
  std::ranges::sort(values);
  return {quantile(values, 0.5 * (1.0 - confidence)), quantile(values, 0.5 * (1.0 + confidence))};
}

/// The interval of a quantity that cannot be below 0: from 0 on where that is the shorter interval.
/// A value that may well be 0 has no draws below, and all of them lie above.
[[nodiscard]] inline std::pair<double, double> quantile_pair_above_zero(std::vector<double>& values,
                                                                        double confidence) {
  const auto [lower, upper] = quantile_pair(values, confidence);
  const double from_zero = quantile(values, confidence);
  if (from_zero <= upper - lower) return {0.0, from_zero};
  return {lower, upper};
}

/// The shortest interval that contains a share of draws. Of a number that limits press to one side
/// it goes on to where the draws are densest, where quantile_pair() leaves some out.
/// @param values      not empty; sorted afterwards.
/// @param confidence  in (0, 1).
[[nodiscard]] inline std::pair<double, double> shortest_interval(std::vector<double>& values,
                                                                 double confidence) {
  std::ranges::sort(values);
  const double share = confidence * static_cast<double>(values.size());
  const auto inside = static_cast<std::size_t>(std::max(1.0, std::ceil(share)));
  std::size_t best = 0;
  for (std::size_t i = 0; i + inside <= values.size(); ++i) {
    const auto width = [&](std::size_t from) { return values[from + inside - 1] - values[from]; };
    if (width(i) < width(best)) best = i;
  }
  return {values[best], values[best + inside - 1]};
}

}  // namespace microslip
