// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/signal/harmonic/cycle_scatter.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"
#include "microslip/signal/harmonic/turning_points.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Faults of a signal that must be excluded before an energy is computed from it.

namespace microslip {

/// The reversals of a signal in one period.
struct Reversals {
  std::vector<TurningPoint> points;  ///< those that count, by time
  double threshold = 0.0;            ///< least difference between neighbours that counts, [x]

  /// 2 for a cycle without inner loops; 0 where no reversal is above the noise.
  [[nodiscard]] std::size_t count() const { return points.size(); }
};

/// Options of the detection of reversals.
struct ReversalOptions {
  /// k; ≥ 0. At 4 noise makes an inner reversal in fewer than one of 10⁴ flat places.
  double noise_factor = 4.0;
};

/// Turning points of the series that differ from their neighbours by more than noise makes them
/// differ: pairs of neighbours are removed, smallest difference first, until all differ by more
/// than
///
///     k √2 σ,    σ² = Σ σ_n², the variance of the fitted series at any one time.
///
/// @param series        of the signal.
/// @param harmonic_std  σ_n, standard error of c_n as FourierFit has it, scaled like c_n where the
///                      series was integrated; [x]. Empty for 0.
/// @param options       k.
[[nodiscard]] Reversals reversals(const FourierSeries& series,
                                  std::span<const double> harmonic_std = {},
                                  const ReversalOptions& options = {});

/// Harmonics 2 … H over the first: √(Σ_{n≥2}|c_n|²)/|c_1|, 1. ∞ where c_1 = 0.
[[nodiscard]] double distortion(const FourierSeries& series);

/// Options of the detection of clipping.
struct ClippingOptions {
  /// Values that count as at the extreme: within this share of the peak-to-peak; [0, 0.01].
  double level_tolerance = 1e-9;
  /// Points in succession that make a flat top; ≥ 2.
  std::size_t least_run = 3;
  /// Share of all points in flat tops above which the signal counts as clipped; ≥ 0. One quantised
  /// sine wave has a few.
  double least_share = 1e-3;
  /// A flat top of a clipped signal meets the slope at an angle; that of a coarsely quantised one
  /// is one step above its neighbours. A run counts where the larger of the steps beside it is
  /// above this many of the smallest steps that the signal makes; ≥ 0.
  double least_step = 1.5;
};

/// Flat tops at the largest and the smallest value.
struct Clipping {
  std::size_t runs = 0;    ///< flat tops
  std::size_t points = 0;  ///< in them
  double share = 0.0;      ///< points over all points, 1
  bool clipped = false;    ///< `share` is above the bound
};
/// Flat tops, see Clipping. @throws InputError  where an option is out of range.
[[nodiscard]] Clipping find_clipping(std::span<const double> signal,
                                     const ClippingOptions& options = {});

/// Options of the detection of drop-outs.
struct DropoutOptions {
  /// Points in succession of one value (away from the extremes) that make a drop-out; ≥ 3.
  std::size_t least_run = 8;
  /// As in ClippingOptions: so a coarsely quantised signal has no drop-outs where it is flat.
  double least_step = 1.5;
  /// A step of the axis above this many median steps is a gap; > 1.
  double gap_factor = 2.5;
};

/// Runs of one value, as of a lost connection, and gaps of the time axis.
struct Dropouts {
  std::size_t runs = 0;         ///< runs of one value, those of flat tops excepted
  std::size_t points = 0;       ///< in them
  std::size_t longest_run = 0;  ///< points
  std::size_t gaps = 0;         ///< of the axis
  double longest_gap = 0.0;     ///< s

  /// Whether there is a run or a gap.
  [[nodiscard]] bool found() const { return runs + gaps > 0; }
};
/// Runs of one value and gaps, see Dropouts. @throws InputError  for an option out of range, or
/// times that do not rise.
[[nodiscard]] Dropouts find_dropouts(const Axis& axis, std::span<const double> signal,
                                     const DropoutOptions& options = {});

/// Options of signal_quality().
struct SignalQualityOptions {
  ReversalOptions reversals;  ///< what counts as a reversal
  ClippingOptions clipping;   ///< what counts as clipped
  DropoutOptions dropouts;    ///< what counts as a drop-out
  /// The amplitude |c_1| drifts where its change over the record is above this share of it …; > 0
  double drift_share = 0.005;
  /// … and its slope above this many of its standard errors; > 0.
  double drift_significance = 4.0;
};

/// All of it for one signal of a fit.
struct SignalQuality {
  Reversals reversals;          ///< of the signal as it is, not of its integral
  double distortion = 0.0;      ///< 1
  Clipping clipping;            ///< flat tops of the signal
  Dropouts dropouts;            ///< runs of one value in it, and gaps of the axis
  Scatter amplitude;            ///< |c_1| cycle by cycle, [x]
  double amplitude_change = 0;  ///< over the record, relative to the mean, signed, 1
  bool drifts = false;          ///< by the options
  /// clipped, dropout, amplitude_drift, each with its figures.
  std::vector<Warning> warnings;
};

/// Checks one signal of a fit.
/// @param axis     of the recording.
/// @param signals  those of the fit, in its order.
/// @param fit      of all signals.
/// @param cycles   cycle_series() of them.
/// @param index    which of them, from 0.
/// @param name     of the signal, for the warnings.
/// @param options  what counts as a fault.
/// @throws InputError  where an option is out of range or the lengths do not fit.
[[nodiscard]] SignalQuality signal_quality(const Axis& axis,
                                           std::span<const std::span<const double>> signals,
                                           const FourierFit& fit, const CycleSeries& cycles,
                                           std::size_t index, std::string_view name,
                                           const SignalQualityOptions& options = {});

}  // namespace microslip
