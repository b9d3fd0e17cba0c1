// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

/// @file
/// A stretch of a signal under the taper cos⁴(πτ/T), τ from −T/2 to T/2, and its Fourier transform
/// at any frequency. Internal to signal.

namespace microslip {

/// The envelope of the taper's transform over that at its middle, d lines of 1/T beside it: without
/// the sine of (4/π) sin(πd)/(d(d² − 1)(d² − 4)); d > 2.
[[nodiscard]] inline double side_lobe(double d) {
  constexpr double kHeight = 4.0 / std::numbers::pi;
  return kHeight / (d * (d * d - 1.0) * (d * d - 4.0));
}

/// The taper at 2τ/T, from −1 to 1.
[[nodiscard]] double taper(double place);

/// Of frequencies between two, T⁻¹/4 apart or less, the one of the largest transform; all in rad/s,
/// the length T in s.
template <typename Transform>
double strongest_of(double from, double to, double length, const Transform& transform) {
  const double step = 2.0 * std::numbers::pi / length / 4.0;
  const auto count = static_cast<std::size_t>(std::ceil((to - from) / step));
  double best = from;
  double most = -1.0;
  for (std::size_t i = 0; i <= count; ++i) {
    const double omega = from + (to - from) * static_cast<double>(i) /
                                    static_cast<double>(std::max<std::size_t>(count, 1));
    const double power = std::norm(transform(omega));
    if (power > most) {
      most = power;
      best = omega;
    }
  }
  return best;
}

class TaperedWindow {
 public:
  /// @param centre  s from the first sample; what lies outside of the signal is left out.
  /// @param length  T, s.
  TaperedWindow(std::span<const double> signal, double rate, double centre, double length);

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] double length() const { return length_; }
  /// 2τ/T of sample i.
  [[nodiscard]] double place(std::size_t i) const {
    return first_ + static_cast<double>(i) * step_;
  }
  [[nodiscard]] double weight(std::size_t i) const { return weights_[i]; }
  [[nodiscard]] double value(std::size_t i) const { return values_[i]; }
  [[nodiscard]] double largest() const;

  /// Σ w y e^{−iωτ}/Σ w. @param omega  rad/s.
  [[nodiscard]] std::complex<double> transform(double omega) const;

  /// Mean square of the transform of white noise of variance 1: Σ w²/(Σ w)².
  [[nodiscard]] double noise_gain() const;

  /// The frequency of the largest transform in a range, to T⁻¹/8. rad/s.
  [[nodiscard]] double strongest(double from, double to) const;

 private:
  std::span<const double> values_;
  double length_;
  double rate_;
  double first_ = 0.0;  ///< place of the first sample
  double step_ = 0.0;   ///< from place to place
  std::vector<double> weights_;
};

}  // namespace microslip
