// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace microslip {

/// Correlation of successive residuals.
struct SerialCorrelation {
  double correlation = 0.0;  ///< 1 − v/2, 1; near that of neighbours
  double deviations = 0.0;   ///< `correlation` over its standard deviation for white residuals, 1
};

/// Estimated from the ratio v = (Σ(r_{i+1} − r_i)²/(n − 1))/(Σr_i²/n) of mean square
/// successive differences, which is 2 for white noise, with (1 − v/2) of standard deviation
/// √((n − 2)/(n² − 1)) [von Neumann]. Nothing, 0 and 0, for fewer than 8 residuals or where
/// all are 0.
/// @param residuals  of mean near 0, in their order, finite.
[[nodiscard]] SerialCorrelation serial_correlation(std::span<const double> residuals);

}  // namespace microslip
