// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/signal/harmonic/fourier_fit_options.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Fourier series of signals that were recorded together and share one fundamental frequency, which
/// is fitted with them [IEEE Std 1057, the four-parameter sine fit, with harmonics and several
/// signals].
///
/// With signal j at time t_i
///
///     y_ji = mean_j + trend_j(t_i) + Σ_{n=1…H} Re(c_jn e^{inωt_i}) + noise of variance σ_j²
///
/// ω maximises the likelihood with each σ_j unknown: it minimises Σ_j ln RSS_j(ω), RSS_j the
/// residual sum of squares when all other coefficients have their best values for this ω (variable
/// projection [G. H. Golub, V. Pereyra, SIAM J. Numer. Anal. 10 (1973) 413]). So each signal weighs
/// with its own scatter. Gauss–Newton steps with halving.
///
/// *Which line is the fundamental.* With a guess: the frequency within `guess_tolerance` of it
/// whose multiples contain most of the power, each signal divided by its variance; so a large
/// second harmonic, or a fundamental missing in one signal, does not mislead. A guess at a fraction
/// of the fundamental is recognised by the missing harmonics. Without one: the strongest line f of
/// the summed spectrum, or f/m, m = 2 … 10, where that period is needed: the multiples of f/m that
/// are not of f contain, in some signal, more than 1e−4 of its power and ten times what noise
/// would; of several the one with the best information criterion (of 2 and 4 first 2); and so on
/// from there. A second harmonic larger than the first is thus not taken for the fundamental, nor a
/// half of the fundamental. A foreign line at just f/2 is; a guess helps.

namespace microslip {

/// The fit. Not converged: `summary.reason` gives the reason, and the rest is the best fit that was
/// found, with series all 0 where there was nothing to fit.
struct FourierFit {
  std::vector<FourierSeries> series;  ///< one per signal, all of one ω and order
  double omega = 0.0;                 ///< ω, rad/s
  double omega_std = 0.0;             ///< its standard error, rad/s
  /// [signal][n − 1]: standard error of the real and of the imaginary part of c_n (rms of the two),
  /// so of |c_n| where it is well above 0, with the zero of time in the middle of the record,
  /// `middle`. Elsewhere the phase nωt of all signals alike is uncertain by n |t − middle|
  /// omega_std, which neither amplitudes nor energies nor phases between signals notice. [x]
  std::vector<std::vector<double>> harmonic_std;
  std::vector<double> residual_rms;     ///< per signal, √(RSS/points), [x]
  std::vector<double> residual_peak;    ///< per signal, the largest of the residuals, [x]; ≥ 0
  std::vector<std::size_t> peak_point;  ///< per signal, the point where that is
  std::vector<double> explained;        ///< per signal, share of the variance explained, 1; 0 … 1
  double middle = 0.0;                  ///< middle of the record, s
  double cycles = 0.0;                  ///< periods in the record, 1
  std::size_t points = 0;               ///< samples in the record
  Summary summary;                      ///< residual: last step of ω, relative
  std::vector<Warning> warnings;        ///< see fit_fourier() and FourierFitOptions

  /// ω/2π, Hz.
  [[nodiscard]] double frequency() const;
  /// H as fitted.
  [[nodiscard]] std::size_t order() const { return series.empty() ? 0 : series.front().order(); }
};

/// Fits the series.
///
/// Not converged, with the reason in the summary: fewer than 3 cycles; too few points per cycle
/// (the fundamental itself above 0.45 of the sampling rate); all signals constant; no periodic
/// content, near the guess or at all; too many iterations. A constant signal among others has
/// coefficients 0 and the warning signal_constant.
///
/// Evenly spaced points cost about 8HJ operations a point and iteration for J signals; others a few
/// times that. 4 to 8 iterations are usual.
/// @param axis     over time; the times rise.
/// @param signals  one at least, each with one value per point of the axis; finite.
/// @param options  what is fitted, and how the fundamental is found.
/// @throws InputError  naming the option or the signal (1-based) and the rule it breaks.
[[nodiscard]] FourierFit fit_fourier(const Axis& axis,
                                     std::span<const std::span<const double>> signals,
                                     const FourierFitOptions& options = {});

}  // namespace microslip
