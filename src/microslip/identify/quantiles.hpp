// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace microslip {

/// The two quantiles between which a share of draws lies, as much below as above; straight between
/// neighbouring draws.
/// @param values      not empty; sorted afterwards.
/// @param confidence  in (0, 1).
[[nodiscard]] inline std::pair<double, double> quantile_pair(std::vector<double>& values,
                                                             double confidence) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(position);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (position - static_cast<double>(low)) * (values[high] - values[low]);
  };
  return {at(0.5 * (1.0 - confidence)), at(0.5 * (1.0 + confidence))};
}

}  // namespace microslip
