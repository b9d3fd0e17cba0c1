// SPDX-License-Identifier: MIT
#include "microslip/joint/secant.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>

#include "microslip/joint/amplitude.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip {
namespace {

using std::numbers::pi;

/// g at ρ = sin²α, α = θ_c/2 in [0, π/2]. The difference α − sin(4α)/4 cancels for small α.
double secant_at_angle(double alpha) {
  const double y = 4.0 * alpha;
  if (y < 0.1) {  // y − sin y by its series; the next term is below 1e−17 of the first
    const double y2 = y * y;
    return y * y2 / (12.0 * pi) *
           (1.0 - y2 / 20.0 * (1.0 - y2 / 42.0 * (1.0 - y2 / 72.0 * (1.0 - y2 / 110.0))));
  }
  return (y - std::sin(y)) / (2.0 * pi);
}

/// ∫ φ g(f*/s) df* over [0, s] of the linear segments, over the angle α with f* = s sin²α: there
/// the integrand is entire, of frequencies up to 8, and 15 Gauss points integrate any of [0, π/2]
/// to rounding. Differences of an antiderivative would lose the digits of steep and of low
/// segments.
double linear_part(const SlipDensity& density, double s) {
  double sum = 0.0;
  const auto segments = density.segments();
  for (std::size_t j = 0; j < segments.size() && segments[j].start < s; ++j) {
    const auto& segment = segments[j];
    if (segment.p == 0.0 && segment.q == 0.0) continue;
    const double end = std::min(s, segments[j + 1].start);  // the last segment is empty
    const double from = std::asin(std::sqrt(segment.start / s));
    const double width = std::asin(std::sqrt(end / s)) - from;
    const auto integrand = [&](double t) {
      const double alpha = from + t;
      const double above_start = s * std::sin(t) * std::sin(from + alpha);  // f* − start
      return (segment.p + segment.q * above_start) * secant_at_angle(alpha) * s *
             std::sin(2.0 * alpha);
    };
    sum += boost::math::quadrature::gauss<double, 15>::integrate(integrand, 0.0, width);
  }
  return sum;
}

double atom_part(const AtomsPart& atoms, double s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < atoms.slip_force.size() && atoms.slip_force[i] <= s; ++i) {
    sum += atoms.weight[i] * jenkins_secant(atoms.slip_force[i] / s);
  }
  return sum;
}

/// From 0 by parts with an incomplete beta function; otherwise by quadrature over the angle α, in
/// which the integrand is analytic.
double power_law_part(const PowerLawPart& part, double s) {
  const double upper = std::min(part.to, s);
  if (!(upper > part.from)) return 0.0;
  const double p = part.exponent + 1.0;
  if (part.from == 0.0) {
    const double partial = boost::math::beta(p + 1.5, 1.5, upper / s);
    return part.coefficient / p *
           (std::pow(upper, p) * jenkins_secant(upper / s) - std::pow(s, p) * 8.0 / pi * partial);
  }
  const auto integrand = [&](double alpha) {
    const double rho = std::sin(alpha) * std::sin(alpha);
    return std::pow(s * rho, part.exponent) * secant_at_angle(alpha) * s * std::sin(2.0 * alpha);
  };
  const double from = std::asin(std::sqrt(part.from / s));
  const double to = std::asin(std::sqrt(upper / s));
  return part.coefficient * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                                integrand, from, to, 12, 1e-13);
}

}  // namespace

double jenkins_secant(double rho) {
  return secant_at_angle(std::asin(std::sqrt(std::clamp(rho, 0.0, 1.0))));
}

double secant_stiffness(const Joint& joint, double amplitude) {
  check_amplitude(amplitude);
  if (amplitude == 0.0) return joint.stiffness();
  const SlipDensity& density = joint.density();
  const double s = joint.stiffness() * amplitude;
  if (std::isinf(s)) return joint.stiffness() * density.elastic_remainder();
  // In macro-slip all but the remainder has slipped, and 1 − Φ0 is rounding.
  double share = s < density.largest_slip_force() ? 1.0 - density.moments(s).zeroth
                                                  : density.elastic_remainder();
  share += linear_part(density, s) + atom_part(density.atoms(), s);
  for (const PowerLawPart& part : density.power_laws()) share += power_law_part(part, s);
  return joint.stiffness() * share;
}

double loss_factor(const Joint& joint, double amplitude) {
  check_amplitude(amplitude);
  if (amplitude == 0.0) return 0.0;
  const double secant = secant_stiffness(joint, amplitude);
  const double stored = pi * secant * amplitude * amplitude;
  if (stored == 0.0) return 0.0;  // below the resolution of squares of doubles
  if (std::isinf(stored))
    return dissipation(joint, amplitude) / amplitude / (pi * secant * amplitude);
  return dissipation(joint, amplitude) / stored;
}

}  // namespace microslip
