// SPDX-License-Identifier: MIT
#include "microslip/base/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_knots(const std::vector<double>& knots, const std::vector<double>& values) {
  if (!knots.empty() && knots.size() == values.size()) return;
  throw InputError("knots", static_cast<double>(knots.size()),
                   "must be as many as values, one at least");
}

}  // namespace

double interpolate(const std::vector<double>& knots, const std::vector<double>& values, double x) {
  check_knots(knots, values);
  if (std::isnan(x)) return x;
  const auto next = std::ranges::upper_bound(knots, x);
  if (next == knots.begin()) return values.front();
  if (next == knots.end()) return values.back();
  const auto i = static_cast<std::size_t>(next - knots.begin());
  const double share = (x - knots[i - 1]) / (knots[i] - knots[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

double integral(const std::vector<double>& knots, const std::vector<double>& values) {
  check_knots(knots, values);
  double sum = 0.0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    sum += 0.5 * (knots[i] - knots[i - 1]) * (values[i] + values[i - 1]);
  }
  return sum;
}

}  // namespace microslip
