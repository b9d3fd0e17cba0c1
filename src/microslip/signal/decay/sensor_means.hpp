// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// @file
/// Means over several sensors of one quantity over time. Internal to signal.

namespace microslip {

/// The value of one sensor at one time.
struct SensorValue {
  double value = 0.0;
  double variance = 0.0;  ///< above 0
  double noise = 0.0;     ///< what of it is its own: ≥ 0, at most the variance
  double size = 1.0;      ///< r, its amplitude over the largest; above 0
};

struct SensorMean {
  double value = 0.0;
  double variance = 0.0;
};

/// Σwx/Σw with w = 1/(variance + s²/r²): s² is 0 where the values about their means agree with
/// their variances, else such that Σw(x − mean)² over all times is what it should be, the number of
/// values less that of the means. The variance is
///
///     Σw²(noise + s²/r²)/(Σw)² + Σw(variance − noise)/Σw.
///
/// Errors other than noise, of the choice of the window and of the theory, are common to the
/// sensors of one decay: they do not fall with their number.
/// @param times  each the values of one time; the mean is that of the time `wanted`.
[[nodiscard]] SensorMean sensor_mean(std::span<const std::vector<SensorValue>> times,
                                     std::size_t wanted);

}  // namespace microslip
