// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// A periodic signal on a slow trend:
///
///     x(t) = mean + Σ_{k=1…K} trend_k P_k(s) + Σ_{n=1…H} Re(c_n e^{inωt}),
///     s = (t − trend_centre)/trend_half_width
///
/// with t that of the recording's axis and the Legendre polynomials P_k: P_1 = s,
/// P_2 = (3s² − 1)/2. A fit lets s run from −1 to 1 over the record, so that each trend_k is the
/// largest value of its term and `mean` the mean over the record. [x] is the unit of the signal.
struct FourierSeries {
  double omega = 0.0;                          ///< ω of the fundamental, rad/s; > 0
  double mean = 0.0;                           ///< [x]
  std::vector<double> trend;                   ///< trend_1 … trend_K, [x]; empty: no trend
  double trend_centre = 0.0;                   ///< s
  double trend_half_width = 1.0;               ///< s; > 0
  std::vector<std::complex<double>> harmonic;  ///< c_1 … c_H, [x]; c_n is harmonic[n − 1]

  /// H, the number of harmonics.
  [[nodiscard]] std::size_t order() const { return harmonic.size(); }
  /// c_n, n ≥ 1; 0 above the order, and for n = 0: the mean is no harmonic.
  [[nodiscard]] std::complex<double> c(std::size_t n) const {
    return n - 1 < harmonic.size() ? harmonic[n - 1] : 0.0;  // 0 − 1 is the largest
  }
  /// ω/2π, Hz.
  [[nodiscard]] double frequency() const;
  /// 2π/ω, s.
  [[nodiscard]] double period() const;
  /// x(t), with mean and trend.
  [[nodiscard]] double value(double t) const;
  /// The sum of the harmonics alone at t.
  [[nodiscard]] double periodic_value(double t) const;
};

/// dx/dt: c_n inω, and the derivative of the trend.
[[nodiscard]] FourierSeries derivative(const FourierSeries& series);

/// The integral of the periodic part that has no mean: c_n/(inω). Mean and trend are dropped: those
/// of an accelerometer do not belong to the motion, and the integral of a mean is not periodic.
/// @throws InputError  where ω is not above 0.
[[nodiscard]] FourierSeries integral(const FourierSeries& series);

/// The signal with another zero of time: t = t_new + origin, so c_n e^{inω·origin}.
/// @param series  on the old axis.
/// @param origin  the new zero on the old axis, s.
[[nodiscard]] FourierSeries shifted(const FourierSeries& series, double origin);

/// √(½ Σ |c_n|²), n from `first` on: the rms of these harmonics. [x]
[[nodiscard]] double rms(const FourierSeries& series, std::size_t first = 1);

/// x(t) at all points of the axis.
/// @param series  of any order.
/// @param axis    over time.
/// @param points  their number; an axis of even steps does not know it.
[[nodiscard]] std::vector<double> values(const FourierSeries& series, const Axis& axis,
                                         std::size_t points);

}  // namespace microslip
