// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace microslip::bench {

/// Largest difference of two histories over the largest value of the exact one, 1.
/// @param found, exact  of the same length.
inline double largest_error(const std::vector<double>& found, const std::vector<double>& exact) {
  double error = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error = std::max(error, std::abs(found[i] - exact[i]));
    largest = std::max(largest, std::abs(exact[i]));
  }
  return error / largest;
}

}  // namespace microslip::bench
