// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"

namespace microslip {

/// How the beginning of a decay was found.
enum class DecayStart {
  kGiven,   ///< the caller
  kRecord,  ///< the mode is largest where the record begins
  kBlow,    ///< a blow in the signal as it was recorded: 1.5 periods of the mode behind its onset
  kFall,    ///< the mode's amplitude, where it leaves its highest 5 %: a plateau, or a later rise
};

/// One of the sensors that recorded a decay.
struct RingDownSensor {
  std::string name;        ///< of the channel
  double ratio = 1.0;      ///< its amplitude over that of the first sensor, 1, above 0
  double ratio_std = 0.0;  ///< its standard deviation
  /// (largest − smallest)/mean of the ratio over the windows, 1: 0 where the mode keeps its shape.
  double ratio_range = 0.0;
};

/// The mode over time: one entry per window, each of the last fitted value at its centre. Windows
/// overlap; two that are half a window apart or more are nearly independent (correlation −0.2).
/// Standard deviations include the noise and the effect of the choice of the window: each is fitted
/// again with 0.8, 1.25 and 1.6 times the length, and the mean square of the differences is added,
/// less the share of the noise and at least what other modes are known to leak in; so is what the
/// windows scatter about smooth courses of ζ, ω and A beyond noise, and what a second oscillation
/// near the mode moves them by, see second_oscillation.hpp. Of several sensors the noise alone
/// falls with their number.
struct RingDown {
  std::vector<double> time;               ///< s, on the axis of the recording
  std::vector<double> amplitude;          ///< A, of the displacement at the sensor, m
  std::vector<double> amplitude_std;      ///< its standard deviation, m
  std::vector<double> frequency;          ///< ω/2π, Hz
  std::vector<double> frequency_std;      ///< its standard deviation, Hz
  std::vector<double> damping_ratio;      ///< ζ above, 1; for a viscous mode ζ/√(1 − ζ²)
  std::vector<double> damping_ratio_std;  ///< its standard deviation, 1
  std::vector<double> loss;               ///< 2πζω²A² = D/m, J/kg
  std::vector<double> loss_std;           ///< with the correlation of ζ and A
  std::vector<double> window;             ///< length of each, s
  /// Codes between blanks: clipped, the range of the signal is 3 % or more below that of its
  /// fundamental; neighbour_leaks, other modes move ζ by more than 2 %; window_matters, the choice
  /// of the window by more than 5 %; beats, a second oscillation too near to be parted, or
  /// steady_tone, one that does not decay, by more than 2 %; of several sensors shape_moves, a
  /// ratio of amplitudes is off its mean by more than 1 % and twice its standard deviation;
  /// sensors_differ, ζ of two (or ω, and by more than 0.01 %) by more than twice the standard
  /// deviation of the difference. Noise alone flags one window in twenty so; the warnings of the
  /// same codes are given where noise alone explains them in one record of a hundred.
  std::vector<std::string> flags;

  double from = 0.0;                         ///< s: the range in which the windows lie
  double to = 0.0;                           ///< s
  double start = 0.0;                        ///< s: where free decay begins, on the axis
  DecayStart start_by = DecayStart::kGiven;  ///< how it was found
  std::optional<double> blow = {};           ///< s: the onset of the blow that was found
  /// Band, Hz: as given, or the pass band of the shortest window.
  std::pair<double, double> band = {0.0, 0.0};
  std::vector<RingDownSensor> sensors;  ///< those that were used, in their order
  /// Standard deviation of the noise of a sample, in the unit of the signal, from the density
  /// beside the mode.
  double noise_std = 0.0;
  Dimension measured = kLength;  ///< what the signal is: kLength, kVelocity or kAcceleration
  /// Converged where the decay was followed until the record ended or the rest was noise. The
  /// residual is noise_std over the first window's amplitude.
  Summary summary;
  std::vector<Warning> warnings;  ///< see the summary for why it ended

  /// The number of windows.
  [[nodiscard]] std::size_t size() const { return time.size(); }
};

}  // namespace microslip
