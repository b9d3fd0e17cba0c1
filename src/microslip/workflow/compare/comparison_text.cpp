// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/workflow/predict/model_text.hpp"

namespace microslip {

std::string shown_name(const ComparedCurve& curve) {
  std::string words = curve.quantity;
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string value_text(double value, const Dimension& dimension) {
  if (!std::isfinite(value)) return "";
  if (dimension == kLength) return length_text(value);
  if (dimension == kDimensionless) return fmt::format("{:.4g}", value);
  return fmt::format("{:.6g} {}", value, si_unit(dimension));
}

std::string difference_text(const ComparedCurve& curve, std::size_t i) {
  if (!curve.compares(i)) return "";
  const double difference = curve.predicted[i] - curve.measured[i];
  if (curve.dimension == kFrequency || curve.dimension == kAngle) {
    return fmt::format("{:+.3g} {}", difference, si_unit(curve.dimension));
  }
  return fmt::format("{:+.1f} %", 100.0 * difference / curve.measured[i]);
}

std::string deviation_text(const ComparedCurve& curve) {
  if (curve.compared() == 0) return "";
  return curve.dimension == kAngle ? fmt::format("{:.3g} rad", curve.deviation())
                                   : fmt::format("{:.3g} %", 100.0 * curve.deviation());
}

}  // namespace microslip
