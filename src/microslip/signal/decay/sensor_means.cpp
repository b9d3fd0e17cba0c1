// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/sensor_means.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

double weight_of(const SensorValue& value, double excess) {
  return 1.0 / (value.variance + excess / (value.size * value.size));
}

SensorMean mean_of(std::span<const SensorValue> values, double excess) {
  double weights = 0.0;
  double sum = 0.0;
  double own = 0.0;
  double shared = 0.0;
  for (const SensorValue& value : values) {
    const double weight = weight_of(value, excess);
    weights += weight;
    sum += weight * value.value;
    own += weight * weight * (value.noise + excess / (value.size * value.size));
    shared += weight * (value.variance - value.noise);
  }
  return {sum / weights, own / (weights * weights) + shared / weights};
}

/// Σw(x − mean)² less what it should be; falls with s².
double surplus(std::span<const std::vector<SensorValue>> times, double excess) {
  double sum = 0.0;
  for (const std::vector<SensorValue>& values : times) {
    if (values.size() < 2) continue;
    const double mean = mean_of(values, excess).value;
    sum -= static_cast<double>(values.size()) - 1.0;
    for (const SensorValue& value : values) {
      const double off = value.value - mean;
      sum += weight_of(value, excess) * off * off;
    }
  }
  return sum;
}

/// s².
double excess_of(std::span<const std::vector<SensorValue>> times) {
  if (surplus(times, 0.0) <= 0.0) return 0.0;
  double high = 0.0;
  for (const std::vector<SensorValue>& values : times) {
    for (const SensorValue& value : values) high = std::max(high, value.variance);
  }
  constexpr int kMost = 200;
  for (int i = 0; i < kMost && surplus(times, high) > 0.0; ++i) high *= 4.0;
  double low = 0.0;
  for (int i = 0; i < kMost && high - low > 1e-6 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (surplus(times, middle) > 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace

SensorMean sensor_mean(std::span<const std::vector<SensorValue>> times, std::size_t wanted) {
  return mean_of(times[wanted], excess_of(times));
}

}  // namespace microslip
