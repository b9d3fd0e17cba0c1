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

/// What the range of a signal lacks of that of its fundamental, in the middle half of a window and
/// at the same samples, over the latter: the fundamental of a sine that is clipped at c is larger
/// than c, 1.27 c at most. Many samples a period, noise and other modes make the range larger,
/// which is negative here; a third harmonic of 3 % in a force that slips flattens by as much. 1,
/// below 0.22.
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

}  // namespace

std::vector<double> clipped_windows(std::span<const double> signal, double rate,
                                    std::span<const DecayWindow> windows, double noise_std) {
  constexpr double kLacking = 0.03;
  constexpr double kSure = 2.0;  // of the noise, at both ends of the range
  std::vector<double> clipped;
  for (const DecayWindow& window : windows) {
    const double lacking = lacking_range(signal, rate, window);
    if (lacking <= kLacking + kSure * noise_std / window.amplitude) break;
    clipped.push_back(lacking);
  }
  return clipped;
}

}  // namespace microslip
