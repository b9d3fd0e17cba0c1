// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/recording.hpp"

/// @file
/// Amplitude, frequency and damping of one mode from its free decay, as functions of time.
///
/// A mode of mass m has a restoring force of Masing's kind: after a reversal at (x_r, f_r) it is
/// f_r − 2F((x_r − x)/2), F the virgin curve of all that restores, joint and linear springs. On the
/// way from a peak A + e to the next, −(A − e), it runs through a branch of the steady loop of
/// amplitude A that is shifted by e along x and, the reversal lying on F up to e², by F′(A)e along
/// f. At both peaks nothing moves, so the work in between vanishes: 2A·F′(A)e = D(A)/2. With 4e,
/// what a cycle takes off A,
///
///     D = A F′(A)·4e = A·[what a cycle takes off F(A)].
///
/// At a peak the force is that of inertia, F(A) = mω²A, so the decay of ω²A counts, that of the
/// acceleration:
///
///     D = −(2π/ω) m A d(ω²A)/dt = 2πζω² m A²,     ζ = (δ − 2ω̇/ω)/ω,     δ = −Ȧ/A,     k_eq = mω²,
///
/// up to terms of the order ζ². In a softening mode ω rises while A falls: ω̇ takes several per
/// cent off δω where the joint has lost a tenth of the mode's stiffness. Viscous losses add to D.
/// Where the frequency moves for another reason than friction (a geometric softening has δ −
/// ω̇/(2ω), by its action ½mωA²) D is wrong by up to 3/2·ω̇/(δω). The amplitudes here are of the
/// first harmonic, which stands for the peak within some tenths of a per cent; where D(A) has a
/// kink, at the beginning of macro-slip, a window rounds it off.

namespace microslip {

/// How ring_down() finds and follows the mode.
struct RingDownOptions {
  /// Near which the mode is sought, within 10 %, Hz: the nearest peak of the spectrum there that
  /// has a third of the height of the highest there. Without it: the highest peak of the spectrum.
  std::optional<double> frequency = {};
  /// Hz, low and high: the mode is sought inside and what is outside is kept out. Without it the
  /// windows are so long that the other peaks of the spectrum move ζ by no more than `wanted_std`.
  std::optional<std::pair<double, double>> band = {};
  /// Where the free decay begins and ends, s on the axis of the recording. Without them: see
  /// DecayStart, and the end of the record.
  std::optional<double> from = {};
  std::optional<double> to = {};  ///< where it ends
  /// The windows are as short as this many periods where noise and other modes allow; from 3.
  double least_periods = 6.0;
  /// ln of the ratio of amplitudes over the shortest window, where the record lasts eight of them;
  /// above 0, up to largest_fall. Over a smaller fall whatever is small looks like damping.
  double least_fall = 0.4;
  /// ln of the ratio of amplitudes over the longest window; above 0, up to 6. A longer window gives
  /// less scatter and more bias where the exponent of D(A) changes fast.
  double largest_fall = 2.0;
  /// Windows are as long as this standard deviation of ζ by noise, over ζ, needs, and as this
  /// change of ζ by other modes; above 0.
  double wanted_std = 0.005;
  /// The decay ends where the longest window does not keep to this one; above 0.
  double largest_std = 0.1;
};

/// What tells where a decay begins.
enum class DecayStart {
  kGiven,   ///< the caller
  kRecord,  ///< the mode is largest where the record begins
  kBlow,    ///< a blow in the signal as it was recorded: 1.5 periods of the mode behind its onset
  kFall,    ///< the mode's amplitude, where it leaves its highest 5 %: a plateau, or a later rise
};

/// One of the sensors that saw a decay.
struct RingDownSensor {
  std::string name;        ///< of the channel
  double ratio = 1.0;      ///< its amplitude over that of the first sensor, 1, above 0
  double ratio_std = 0.0;  ///< its standard deviation
  /// (largest − smallest)/mean of the ratio over the windows, 1: 0 where the mode keeps its shape.
  double ratio_range = 0.0;
};

/// The mode over time: one entry a window, each of the last fitted value at its centre. Windows
/// overlap; two that are half a window apart or more are all but independent (correlation −0.2).
/// Standard deviations hold the noise and what the choice of the window is worth: each is fitted
/// again with 0.8, 1.25 and 1.6 times the length, and the mean square of the differences is added,
/// less the share of the noise and at least what other modes are known to leak in; so is what the
/// windows scatter about smooth courses of ζ, ω and A beyond noise, and what a second oscillation
/// near the mode moves them by, see second_oscillation.hpp. Of several sensors the noise
/// alone falls with their number.
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
  /// Codes between blanks: neighbour_leaks, other modes move ζ by more than 2 %; window_matters,
  /// the choice of the window by more than 5 %; beats, a second oscillation too near to be parted,
  /// or steady_tone, one that does not decay, by more than 2 %; of several sensors shape_moves, a
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
  /// Hz: as given, or what the shortest window lets through.
  std::pair<double, double> band = {0.0, 0.0};
  std::vector<RingDownSensor> sensors;  ///< those that were used, in their order
  /// Of a sample, in the unit of the signal, by the density beside the mode.
  double noise_std = 0.0;
  Dimension measured = kLength;  ///< what the signal is: kLength, kVelocity or kAcceleration
  /// Converged where the decay was followed until the record ended or the rest was noise. The
  /// residual is noise_std over the first window's amplitude.
  Summary summary;
  std::vector<Warning> warnings;  ///< see the summary for why it ended

  /// The number of windows.
  [[nodiscard]] std::size_t size() const { return time.size(); }
};

/// Follows the decay of a signal.
/// @param signal    evenly sampled, in SI. Its first sample is at time 0.
/// @param rate      of the samples, Hz.
/// @param measured  what it is: kLength, kVelocity or kAcceleration.
/// @param options   which mode, when, and how it is followed.
/// @throws InputError  for options out of range; where the signal is not finite, too short,
///                     clipped, or holds no decay above the noise, where no peak is near the
///                     frequency, and where a higher peak beside the chosen one is followed.
[[nodiscard]] RingDown ring_down(std::span<const double> signal, double rate,
                                 const Dimension& measured, const RingDownOptions& options = {});

/// The same of a channel; its unit tells what it is.
/// @throws InputError  also where the channel is missing, not evenly sampled over time or of no
///                     motion.
[[nodiscard]] RingDown ring_down(const Recording& recording, std::string_view channel,
                                 const RingDownOptions& options = {});

/// The same of several sensors of one decay. The first says which mode: the others look for a peak
/// near its, and one whose frequency is off by more than 1 % is left out. The one that tells ζ best
/// leads: in its windows all are fitted. ζ, ω and A are weighted means; amplitude and modal mass
/// are those of the first sensor, to which the mean ratios of amplitudes bring the others. A weight
/// is 1/(σ² + s²/r²): σ the sensor's own, r its amplitude over the largest, and s what explains
/// that the sensors differ by more than their σ, over the windows within half a window [R.
/// DerSimonian, N. Laird, Control. Clin. Trials 7 (1986) 177, there with r = 1]: what is foreign to
/// the mode counts more where its amplitude is small.
/// @param recording  of the decay.
/// @param channels   one at least, no two the same. One that cannot be followed, or follows another
///                   mode than the first, is left out with a warning.
/// @param options    which mode, when, and how it is followed.
/// @throws InputError  as for one; where the first cannot be followed.
[[nodiscard]] RingDown ring_down(const Recording& recording, std::span<const std::string> channels,
                                 const RingDownOptions& options = {});

}  // namespace microslip
