// SPDX-License-Identifier: MIT
#include "microslip/observe/neighbour_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"

namespace microslip {

double scatter_about_neighbours(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < 3 || y.size() != n) {
    throw InputError("number of points", static_cast<double>(n),
                     "must be 3 or more, with one y each");
  }
  std::vector<double> deviations;
  deviations.reserve(n - 2);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = (x[i + 1] - x[i]) / (x[i + 1] - x[i - 1]);
    const double right = 1.0 - left;
    const double deviation = left * y[i - 1] + right * y[i + 1] - y[i];
    deviations.push_back(std::abs(deviation) / std::sqrt(left * left + right * right + 1.0));
  }
  constexpr double kMedianOfNormal = 0.6744897501960817;  // of |z|, z standard normal
  return median(std::move(deviations)) / kMedianOfNormal;
}

}  // namespace microslip
