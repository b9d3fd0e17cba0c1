// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

#include "microslip/signal/decay/tapered_transform.hpp"

namespace microslip {
namespace {

/// Smallest and largest value so far.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  [[nodiscard]] double range() const { return most - least; }
};

/// e^{u(τ) − u} of a window, see decay_window.hpp.
double envelope(const DecayWindow& window, double tau) {
  constexpr double kExponential = 1e-6;
  const double fall = window.decay * tau;
  if (std::abs(window.exponent) < kExponential) return std::exp(-fall);
  const double base = 1.0 + window.exponent * fall;
  return base > 0.0 ? std::pow(base, -1.0 / window.exponent) : 0.0;
}

}  // namespace

double lacking_range(std::span<const double> signal, double rate, const DecayWindow& window) {
  const TaperedWindow samples(signal, rate, window.centre, window.length);
  const double phase = std::arg(samples.transform(window.omega));
  Extremes measured;
  Extremes fitted;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    constexpr double kMiddle = 0.5;  // of half the length
    if (std::abs(samples.place(i)) > kMiddle) continue;
    const double tau = samples.place(i) * window.length / 2.0;
    measured.add(samples.value(i));
    fitted.add(window.amplitude * envelope(window, tau) *
               std::cos(phase + window.omega * tau + window.chirp * tau * tau / 2.0));
  }
  if (!(fitted.range() > 0.0)) return 0.0;
  return 1.0 - measured.range() / fitted.range();
}

}  // namespace microslip
