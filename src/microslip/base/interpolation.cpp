// SPDX-License-Identifier: MIT
#include "microslip/base/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "microslip/base/error.hpp"

namespace microslip {

double interpolate(const std::vector<double>& knots, const std::vector<double>& values, double x) {
  if (knots.empty() || knots.size() != values.size()) {
    throw InputError("knots", static_cast<double>(knots.size()),
                     "must be as many as values, one at least");
  }
  if (std::isnan(x)) return x;
  const auto next = std::ranges::upper_bound(knots, x);
  if (next == knots.begin()) return values.front();
  if (next == knots.end()) return values.back();
  const auto i = static_cast<std::size_t>(next - knots.begin());
  const double share = (x - knots[i - 1]) / (knots[i] - knots[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace microslip
