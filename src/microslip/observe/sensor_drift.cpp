// SPDX-License-Identifier: MIT
#include "microslip/observe/sensor_drift.hpp"

#include <cstddef>

namespace microslip {
namespace {

void subtract(const std::vector<double>& coefficients, std::vector<double>& values) {
  if (coefficients.empty()) return;
  const auto last = static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] -= drift_at(coefficients, static_cast<double>(i) / last);
  }
}

}  // namespace

double drift_at(const std::vector<double>& coefficients, double time) {
  double sum = 0.0;
  for (std::size_t p = coefficients.size(); p-- > 0;) sum = time * (sum + coefficients[p]);
  return sum;
}

ForceRecord without_drift(ForceRecord record, const SensorDrift& drift) {
  subtract(drift.displacement, record.displacement);
  subtract(drift.force, record.force);
  return record;
}

}  // namespace microslip
