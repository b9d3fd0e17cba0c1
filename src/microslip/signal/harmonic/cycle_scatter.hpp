// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// The Fourier coefficients of each cycle of a record, at the ω fitted to the whole of it.
struct CycleSeries {
  int cycles_per_block = 0;    ///< 1, or more where a cycle has too few points
  std::vector<double> middle;  ///< of each block, s
  /// [block][signal]; origin of time that of the axis, no trend.
  std::vector<std::vector<FourierSeries>> block;
};

/// How cycle_series() fits.
struct CycleSeriesOptions {
  /// Harmonics of each cycle; ≥ 1. Not above that of the fit.
  int order = 10;
};

/// Fits mean and harmonics to each whole cycle of the record by linear least squares, after the
/// trend of the whole record is subtracted. The first cycle begins with the record; the rest at the
/// end is not used. Where a cycle has fewer than 2(2H + 1) points, a block of several cycles that
/// has as many replaces it. Blocks with a gap of uneven times as long as half a period of the
/// highest harmonic are left out: they do not determine it.
/// @param axis     over time.
/// @param signals  each with one value per point of the axis.
/// @param fit      of the same axis and signals, converged.
/// @param options  how many harmonics.
/// @throws InputError  where axis, signals and fit do not match, or ω is not above 0.
[[nodiscard]] CycleSeries cycle_series(const Axis& axis,
                                       std::span<const std::span<const double>> signals,
                                       const FourierFit& fit,
                                       const CycleSeriesOptions& options = {});

/// Mean of consecutive values, one per cycle, and its scatter.
struct Scatter {
  std::size_t count = 0;        ///< values, 1
  double mean = 0.0;            ///< [y]
  double deviation = 0.0;       ///< s, standard deviation of one value about the mean, [y]
  double correlation = 0.0;     ///< ρ, of neighbours, 1; 0 … 1
  double standard_error = 0.0;  ///< of the mean, [y]
  double slope = 0.0;           ///< of the straight line through the values, [y] a value
  double slope_std = 0.0;       ///< its standard error, [y] a value
  /// |slope|/slope_std, 1; above 4 chance is no explanation of the drift, below 2 it may be.
  [[nodiscard]] double slope_significance() const;
};

/// Mean and scatter, with the correlation of neighbours:
///
///     standard_error² = s²/N · (1 + ρ)/(1 − ρ)
///
/// ρ is the correlation of lag 1, its bias 1/N added and its standard error 1/√N subtracted: the
/// correlation that chance gives independent values does not count. Negative counts as 0, and 0.9
/// is the largest [AR(1); G. E. P. Box, G. M. Jenkins, Time Series Analysis, 1970]. The same
/// factor, from the residuals of the straight line, enters slope_std. Standard errors are NaN for
/// fewer than 4 values: so few are not enough.
/// @param values  1 at least.
[[nodiscard]] Scatter scatter(std::span<const double> values);

/// scatter() of a quantity that is computed from the series of each cycle. A quantity that is
/// quadratic in one coefficient, |c|², has in its mean a bias of twice the variance of Re c.
/// @param cycles    by cycle_series().
/// @param quantity  from the series of all signals in one block.
[[nodiscard]] Scatter scatter(
    const CycleSeries& cycles,
    const std::function<double(std::span<const FourierSeries>)>& quantity);

}  // namespace microslip
