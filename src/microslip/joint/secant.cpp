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
/// @param sine  sin 4α.
double secant_at_angle(double alpha, double sine) {
  const double y = 4.0 * alpha;
  if (y < 0.1) {  // y − sin y by its series; the next term is below 1e−17 of the first
    const double y2 = y * y;
    return y * y2 / (12.0 * pi) *
           (1.0 - y2 / 20.0 * (1.0 - y2 / 42.0 * (1.0 - y2 / 72.0 * (1.0 - y2 / 110.0))));
  }
  return (y - sine) / (2.0 * pi);
}

double secant_at_angle(double alpha) { return secant_at_angle(alpha, std::sin(4.0 * alpha)); }

/// The integrand φ g df*/dα of a linear segment that begins at the angle `from`.
struct SegmentIntegrand {
  double p;  ///< the density where the segment begins, 1/N
  double q;  ///< and its slope, 1/N²
  double s;
  double from;

  /// @param t  α − from.
  double operator()(double t) const {
    const double alpha = from + t;
    const double sine = std::sin(2.0 * alpha);
    const double cosine = std::cos(2.0 * alpha);
    const double sine_t = std::sin(t);
    const double above_start = s * sine_t * (sine * std::cos(t) - cosine * sine_t);  // f* − start
    return (p + q * above_start) * secant_at_angle(alpha, 2.0 * sine * cosine) * s * sine;
  }

  /// ∫ over [from, from + width]. The integrand is entire, of frequencies up to 8: the error of n
  /// Gauss points is below (n!)⁴(8 width)²ⁿ/[(2n + 1)(2n)!³] of it, which is rounding of 15 points
  /// at π/2, of 7 at 0.2 and of 2 at 1e−4.
  [[nodiscard]] double integral(double width) const {
    using boost::math::quadrature::gauss;
    if (width > 0.2) return gauss<double, 15>::integrate(*this, 0.0, width);
    if (width > 1e-4) return gauss<double, 7>::integrate(*this, 0.0, width);
    const double half = 0.5 * width;
    const double offset = half / std::numbers::sqrt3;
    return half * ((*this)(half - offset) + (*this)(half + offset));
  }
};

/// ∫ φ g(f*/s) df* over [0, s] of the linear segments, over the angle α with f* = s sin²α.
/// Differences of an antiderivative would lose the digits of steep and of low segments.
double linear_part(const SlipDensity& density, double s) {
  double sum = 0.0;
  const auto segments = density.segments();
  if (segments.empty() || !(segments.front().start < s)) return sum;
  double from = std::asin(std::sqrt(segments.front().start / s));
  for (std::size_t j = 0; j + 1 < segments.size() && segments[j].start < s; ++j) {
    const auto& segment = segments[j];
    const double end = std::min(s, segments[j + 1].start);  // the last segment is empty
    const double to = std::asin(std::sqrt(end / s));
    if (segment.p != 0.0 || segment.q != 0.0) {
      sum += SegmentIntegrand{segment.p, segment.q, s, from}.integral(to - from);
    }
    from = to;
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
