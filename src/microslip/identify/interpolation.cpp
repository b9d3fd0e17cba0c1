// SPDX-License-Identifier: MIT
#include "microslip/identify/interpolation.hpp"

#include <algorithm>
#include <cstddef>

namespace microslip {

double interpolate(const std::vector<double>& knots, const std::vector<double>& values, double f) {
  const auto next = std::ranges::upper_bound(knots, f);
  if (next == knots.begin()) return values.front();
  if (next == knots.end()) return values.back();
  const auto i = static_cast<std::size_t>(next - knots.begin());
  const double share = (f - knots[i - 1]) / (knots[i] - knots[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace microslip
