// SPDX-License-Identifier: MIT
#include "microslip/joint/power_law.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace microslip {
namespace {

/// ∫ f^(p−1) df over [a, b] = (b^p − a^p)/p, by log1p and expm1 so that neither b → a nor p → 0
/// cancels.
double power_integral(double p, double a, double b) {
  if (a == 0.0) return std::pow(b, p) / p;
  const double log_ratio = std::log1p((b - a) / a);
  const double scale = std::pow(a, p);
  return p == 0.0 ? log_ratio : scale * std::expm1(p * log_ratio) / p;
}

/// ∫ f^n (s − f) φ df, n = 0 or 1. The difference of two moments loses digits where the interval is
/// short against its distance from 0. There f^(p−1) is so smooth that 15 Gauss points integrate it
/// to rounding: the nearest singularity, f = 0, bounds the error by (3 + √8)^−30 ≈ 1e−23. A steep
/// power is that smooth on a shorter interval only.
double weighted_deficit(const PowerLawPart& part, double s, int n) {
  const double upper = std::min(part.to, s);
  if (!(upper > part.from)) return 0.0;
  const double p = part.exponent + n + 1.0;
  if (part.from == 0.0 && s <= part.to) {
    return part.coefficient * std::pow(s, p + 1.0) / (p * (p + 1.0));
  }
  const double width = upper - part.from;
  if (width * std::max(1.0, std::abs(p) / 8.0) < part.from) {
    // Over t = f − from, in which s − f keeps its digits.
    const double gap = s - part.from;
    const auto integrand = [&](double t) { return (gap - t) * std::pow(part.from + t, p - 1.0); };
    return part.coefficient *
           boost::math::quadrature::gauss<double, 15>::integrate(integrand, 0.0, width);
  }
  return part.coefficient *
         (s * power_integral(p, part.from, upper) - power_integral(p + 1.0, part.from, upper));
}

}  // namespace

PartialMoments power_law_moments(const PowerLawPart& part, double s) {
  const double upper = std::min(part.to, s);
  if (!(upper > part.from)) return {};
  const double p = part.exponent + 1.0;
  return {part.coefficient * power_integral(p, part.from, upper),
          part.coefficient * power_integral(p + 1.0, part.from, upper),
          part.coefficient * power_integral(p + 2.0, part.from, upper)};
}

double power_law_weight(const PowerLawPart& part, double s) {
  const double upper = std::min(part.to, s);
  if (!(upper > part.from)) return 0.0;
  return part.coefficient * power_integral(part.exponent + 1.0, part.from, upper);
}

double power_law_force_deficit(const PowerLawPart& part, double s) {
  return weighted_deficit(part, s, 0);
}

PowerLawSlip power_law_slip(const PowerLawPart& part, double s) {
  if (part.from == 0.0 && s > 0.0 && s <= part.to) {
    const double p = part.exponent + 1.0;
    const double weight = part.coefficient * std::pow(s, p) / p;
    return {weight, weight * s / (p + 1.0)};
  }
  return {power_law_weight(part, s), power_law_force_deficit(part, s)};
}

double power_law_slip_energy(const PowerLawPart& part, double s) {
  return weighted_deficit(part, s, 1);
}

}  // namespace microslip
