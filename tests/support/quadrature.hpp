// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace microslip::testing {

/// ∫ f(x) dx over [a, b] by the tanh-sinh rule in long double, halving the step until the sum
/// stands still. It converges at any integrable end-point singularity; the abscissas near a are
/// exact when a = 0. Shares nothing with the Gauss rules and closed forms of the library.
template <typename Function>
long double integrate(const Function& f, long double a, long double b) {
  if (!(b > a)) return 0.0L;
  const long double half_pi = std::acos(-1.0L) / 2.0L;
  const auto term = [&](long double t) {
    // u = the share of the interval from its nearer end, without cancellation.
    const long double e = std::exp(-2.0L * half_pi * std::sinh(std::abs(t)));
    const long double u = e / (1.0L + e);
    const long double weight = 2.0L * half_pi * std::cosh(t) * u / (1.0L + e);
    if (!(weight > 0.0L)) return 0.0L;
    const long double x = t < 0.0L ? a + (b - a) * u : b - (b - a) * u;
    if (!(x > a && x < b)) return 0.0L;
    const long double value = f(x);
    if (!std::isfinite(value)) throw std::domain_error("the integrand is not finite");
    return weight * value;
  };
  constexpr long double kReach = 8.0L;  // u there is far below the smallest double
  long double step = 1.0L;
  long double sum = term(0.0L);
  for (long double t = step; t <= kReach; t += step) sum += term(t) + term(-t);
  long double previous = sum * step;
  for (int level = 0; level < 9; ++level) {
    step /= 2.0L;
    for (long double t = step; t <= kReach; t += 2.0L * step) sum += term(t) + term(-t);
    const long double now = sum * step;
    if (level > 3 && std::abs(now - previous) <= 1e-17L * std::abs(now)) return now * (b - a);
    previous = now;
  }
  return previous * (b - a);
}

/// The same with the interval cut at `kinks`, where f is not smooth.
template <typename Function>
long double integrate(const Function& f, long double a, long double b, std::vector<double> kinks) {
  std::ranges::sort(kinks);
  long double sum = 0.0L;
  long double from = a;
  for (const double kink : kinks) {
    if (!(kink > from && kink < b)) continue;
    sum += integrate(f, from, kink);
    from = kink;
  }
  return sum + integrate(f, from, b);
}

}  // namespace microslip::testing
