// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/serial_correlation.hpp"

#include <cmath>
#include <cstddef>

namespace microslip {

SerialCorrelation serial_correlation(std::span<const double> residuals) {
  constexpr std::size_t kLeast = 8;
  if (residuals.size() < kLeast) return {};
  double squares = 0.0;
  double differences = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    squares += residuals[i] * residuals[i];
    if (i > 0) differences += std::pow(residuals[i] - residuals[i - 1], 2);
  }
  if (squares == 0.0) return {};
  const auto n = static_cast<double>(residuals.size());
  const double correlation = 1.0 - n / (n - 1.0) * differences / (2.0 * squares);
  return {correlation, correlation * std::sqrt((n * n - 1.0) / (n - 2.0))};
}

}  // namespace microslip
