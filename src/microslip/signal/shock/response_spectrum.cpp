// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/response_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "microslip/base/error.hpp"
#include "microslip/base/work_size.hpp"

namespace microslip {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double kStepsPerPeriod = 40.0;

/// The extremes of a signal at equal or unequal times, those between them by a parabola.
class SignalExtremes {
 public:
  void add(double time, double value) {
    if (count_ >= 2) look(time, value);
    highest = std::max(highest, value);
    lowest = std::min(lowest, value);
    t_[0] = t_[1];
    x_[0] = x_[1];
    t_[1] = time;
    x_[1] = value;
    ++count_;
  }

  double highest = 0.0;
  double lowest = 0.0;

 private:
  /// Whether the middle one of three is an extreme.
  void look(double time, double value) {
    const bool high = x_[1] >= x_[0] && x_[1] >= value;
    const bool low = x_[1] <= x_[0] && x_[1] <= value;
    if (high == low) return;
    const double h0 = t_[1] - t_[0];
    const double h1 = time - t_[1];
    const double d0 = (x_[1] - x_[0]) / h0;
    const double d1 = (value - x_[1]) / h1;
    const double curvature = (d1 - d0) / (h0 + h1);
    const double slope = (d0 * h1 + d1 * h0) / (h0 + h1);
    if (curvature == 0.0) return;
    const double top = x_[1] - slope * slope / (4.0 * curvature);
    if (high) highest = std::max(highest, top);
    if (low) lowest = std::min(lowest, top);
  }

  double t_[2] = {};
  double x_[2] = {};
  std::size_t count_ = 0;
};

/// z and ż of one mass during the march.
class Oscillator {
 public:
  Oscillator(double omega, double damping_ratio)
      : omega_(omega),
        damping_(damping_ratio),
        lambda_(-damping_ratio * omega, omega * std::sqrt(1.0 - damping_ratio * damping_ratio)) {}

  /// Advances over a step in which the acceleration goes from `a` with `slope`. The particular
  /// solution is linear in time, the rest evolves with e^{λt}.
  void go(double step, double a, double slope) {
    const double square = omega_ * omega_;
    const double drift = -slope / square;
    const double offset = (-a - 2.0 * damping_ * omega_ * drift) / square;
    const double z0 = z_ - offset;
    const double v0 = v_ - drift;
    // z = Re(c e^{λt}), ż = Re(cλe^{λt})
    const Complex c(z0, (lambda_.real() * z0 - v0) / lambda_.imag());
    if (step != step_) {
      step_ = step;
      turn_ = std::exp(lambda_ * step);
    }
    const Complex turned = c * turn_;
    z_ = turned.real() + offset + drift * step;
    v_ = (turned * lambda_).real() + drift;
  }

  [[nodiscard]] double displacement() const { return z_; }
  /// ẍ of the mass.
  [[nodiscard]] double acceleration() const {
    return -omega_ * (2.0 * damping_ * v_ + omega_ * z_);
  }

 private:
  double omega_;
  double damping_;
  Complex lambda_;
  double z_ = 0.0;
  double v_ = 0.0;
  double step_ = -1.0;
  Complex turn_;
};

struct LargestMotions {
  SignalExtremes acceleration;
  SignalExtremes displacement;
};

LargestMotions largest_of(std::span<const double> time, std::span<const double> a, double frequency,
                          double damping_ratio) {
  Oscillator mass(2.0 * pi * frequency, damping_ratio);
  LargestMotions found;
  const auto pass = [&](double begin, double length, double from, double slope) {
    const double pieces = std::max(1.0, std::ceil(kStepsPerPeriod * frequency * length));
    const double step = length / pieces;
    for (std::size_t i = 0; static_cast<double>(i) < pieces; ++i) {
      mass.go(step, from + slope * step * static_cast<double>(i), slope);
      const double now = begin + step * static_cast<double>(i + 1);
      found.acceleration.add(now, mass.acceleration());
      found.displacement.add(now, mass.displacement());
    }
  };
  for (std::size_t k = 0; k + 1 < time.size(); ++k) {
    const double length = time[k + 1] - time[k];
    pass(time[k], length, a[k], (a[k + 1] - a[k]) / length);
  }
  pass(time.back(), 1.0 / frequency, 0.0, 0.0);
  return found;
}

void check_shaken(std::span<const double> time, std::span<const double> acceleration,
                  std::span<const double> frequencies, double damping_ratio) {
  if (time.size() < 2 || acceleration.size() != time.size()) {
    throw InputError("times of a response spectrum", static_cast<double>(time.size()),
                     "must be at least 2, with an acceleration each");
  }
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(acceleration[i])) {
      throw InputError(fmt::format("acceleration[{}]", i), acceleration[i], "must be finite");
    }
    if (std::isfinite(time[i]) && (i == 0 || time[i] > time[i - 1])) continue;
    throw InputError(fmt::format("time[{}]", i), time[i], "must be later than the previous time");
  }
  for (const double f : frequencies) {
    if (std::isfinite(f) && f > 0.0) continue;
    throw InputError("natural frequency", f, "must be above 0 Hz");
  }
  if (!(damping_ratio >= 0.0 && damping_ratio < 1.0)) {
    throw InputError("damping ratio", damping_ratio, "must be from 0 and below 1");
  }
  double steps = 0.0;
  for (const double f : frequencies) {
    steps += static_cast<double>(time.size()) + kStepsPerPeriod * f * (time.back() - time.front());
  }
  check_steps(
      "steps of a response spectrum", steps,
      fmt::format("{} natural frequencies over {} samples", frequencies.size(), time.size()),
      "Take fewer or lower natural frequencies, or a shorter record.");
}

}  // namespace

std::vector<double> ResponseSpectrum::maximax() const {
  std::vector<double> larger;
  for (std::size_t i = 0; i < positive.size(); ++i) {
    larger.push_back(std::max(positive[i], negative[i]));
  }
  return larger;
}

ResponseSpectrum response_spectrum(std::span<const double> time,
                                   std::span<const double> acceleration,
                                   std::span<const double> frequencies, double damping_ratio) {
  check_shaken(time, acceleration, frequencies, damping_ratio);
  ResponseSpectrum spectrum;
  for (const double f : frequencies) {
    const LargestMotions largest = largest_of(time, acceleration, f, damping_ratio);
    spectrum.frequency.push_back(f);
    spectrum.positive.push_back(largest.acceleration.highest);
    spectrum.negative.push_back(-largest.acceleration.lowest);
    spectrum.displacement.push_back(
        std::max(largest.displacement.highest, -largest.displacement.lowest));
  }
  return spectrum;
}

}  // namespace microslip
