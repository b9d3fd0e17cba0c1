// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/signal/harmonic/fourier_series.hpp"

namespace microslip {

/// A maximum or minimum of a signal.
struct TurningPoint {
  double time;   ///< s, on the axis of the recording
  double value;  ///< of the periodic part, without mean and trend; [x]
};

/// The maxima and minima of the periodic part over the period that begins at t = 0, by rising time:
/// the changes of sign of Σ Re(c_n inω e^{inωt}), 2H at the most, bracketed on a grid of 32 points
/// a period of the highest harmonic and then found to rounding. A maximum and a minimum that lie
/// closer than the grid are not seen: their difference is below 1e−3 of the highest harmonics.
/// Their number is even; it is 0 where all c_n are 0.
[[nodiscard]] std::vector<TurningPoint> turning_points(const FourierSeries& series);

/// The largest and the smallest value of the periodic part.
struct PeakToPeak {
  double largest = 0.0;   ///< [x]
  double smallest = 0.0;  ///< [x]

  /// (largest − smallest)/2: the amplitude of a cycle between reversals, [x].
  [[nodiscard]] double amplitude() const { return 0.5 * (largest - smallest); }
  /// (largest + smallest)/2: where the middle of the cycle lies off its mean, [x].
  [[nodiscard]] double middle() const { return 0.5 * (largest + smallest); }
};
/// Both by turning_points(); 0 where all c_n are 0.
[[nodiscard]] PeakToPeak peak_to_peak(const FourierSeries& series);

}  // namespace microslip
