// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "microslip/algebra/core.hpp"
#include "microslip/signal/harmonic/harmonic_basis.hpp"

namespace microslip {

/// Power spectra of the signals of a record, to find where to begin: by FFT with a Hann window,
/// which keeps a strong line from covering weak ones a few lines away. Uneven times are resampled
/// linearly. Frequencies are in cycles a record: f·length. Internal to signal.
class LineSpectrum {
 public:
  /// @param signals  points × signals; without mean and trend, of mean square 1.
  /// @param highest  frequencies up to which lines are sought, as well as the rate of the points
  ///                 allows: where it is far higher, means of neighbours are transformed.
  LineSpectrum(const RecordTimes& times, const Eigen::MatrixXd& signals, double highest);

  /// Mean square of a line at this frequency, as a share of the signal's: at its peak and for a
  /// sine wave 1. Interpolated; 0 off the spectrum.
  [[nodiscard]] double power(double cycles, Eigen::Index signal) const;
  /// The largest share of a line's power at a distance from it, in cycles per record: that of the
  /// window, (1/(π d (d² − 1)))². 1 within its main lobe, |d| < 2.
  [[nodiscard]] static double leakage(double distance);
  /// Its mean over the spectrum of noise: from the median, which lines do not move.
  [[nodiscard]] double noise(Eigen::Index signal) const { return noise_(signal); }
  /// The strongest line of the sum over the signals between two frequencies; none where there is no
  /// power.
  [[nodiscard]] std::optional<double> strongest(double from, double to) const;
  /// The frequency in the range whose multiples 1 … order have the largest power.
  [[nodiscard]] double strongest_comb(double from, double to, Eigen::Index order) const;
  /// The multiple of a frequency, 1 … order, with the largest power.
  [[nodiscard]] Eigen::Index strongest_multiple(double cycles, Eigen::Index order) const;

 private:
  [[nodiscard]] double total(double cycles) const;

  double bins_per_cycle_ = 1.0;
  Eigen::MatrixXd power_;  ///< frequencies × signals
  Eigen::VectorXd total_;
  Eigen::VectorXd noise_;
};

}  // namespace microslip
