// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/rig.hpp"
#include "microslip/rig/stick_state.hpp"
#include "microslip/signal/fourier_fit.hpp"
#include "microslip/signal/recording.hpp"

/// @file
/// From a steady record to a level: what the joint dissipated in a cycle, and at which amplitude.

namespace microslip {

/// Flags that decide whether a level is used.
inline constexpr std::string_view kInnerReversals = "inner_reversals";
inline constexpr std::string_view kNegativeDissipation = "dissipation_negative";  ///< D < 0

/// A value with its standard deviation.
struct Measured {
  double value = 0.0;  ///< in the unit of what is measured
  double std = 0.0;    ///< 0 where nothing is known of it
};

/// What one record tells.
struct ReducedLevel {
  std::string source;                ///< of the record
  double frequency = 0.0;            ///< of the cycle, as fitted, Hz
  double resonance_frequency = 0.0;  ///< of the structure at this amplitude, Hz
  double force_amplitude = 0.0;      ///< |F_1|, N
  double response_amplitude = 0.0;   ///< |A_1| at the exciter, m/s²
  Measured amplitude;                ///< A, half of the joint displacement peak to peak, m
  Measured dissipation;              ///< D = W_ext − W_lin, J [AR14 (15)]
  Measured input_energy;             ///< W_ext, J [AR14 (16)]
  /// W_ext by the sum over the samples, J [AR14 (17)]; where an accelerometer is at the exciter.
  std::optional<Measured> input_energy_by_sum = {};
  double linear_dissipation = 0.0;  ///< W_lin, J [AR14 (18), harmonic n counted n times]
  std::optional<Measured> secant_stiffness = {};  ///< k_eq, N/m; nothing where k is not known
  /// Harmonics 2 … H of the force over the first, 1; less what the noise of the channel alone
  /// shows.
  double force_distortion = 0.0;
  std::size_t reversals = 2;  ///< of the joint displacement in a cycle
  double cycles = 0.0;        ///< in the record
  double misfit = 0.0;        ///< the worst of the accelerometers against the rig's motion, 1
  /// What is to be looked at, each once; `code` is what the column `flags` of levels.csv shows.
  std::vector<Warning> flags = {};

  /// Whether one of the flags has this code.
  [[nodiscard]] bool has_flag(std::string_view code) const;
};

/// How Reducer reduces, and what it flags.
struct ReductionOptions {
  /// Order 10 as a rule. In a test at resonance the strongest line is the fundamental.
  FourierFitOptions fit = {.seek_longer_period = false};
  std::size_t modes = 0;       ///< see stick_state()
  bool use_vibrometer = true;  ///< false: the joint displacement from the kinematics all the same
  double most_distortion = 0.01;  ///< of the force without the flag force_distortion, 1; above 0
  double most_misfit = 0.05;      ///< without the flag model_misfit, 1; above 0
  double most_mismatch = 0.2;  ///< of vibrometer and kinematics without a flag, relative; above 0
  double most_phase = 0.05;    ///< rad; of a cycle against the whole record without a flag; above 0
};

/// Reduces the records of one test. Shared by threads.
///
/// A record is fitted by Fourier series with a common fundamental; modal coordinates follow from
/// force and accelerations (ModalObserver), W_lin from them in the stick-state modes with their own
/// ω_i: the linear damping was identified there and does not change with amplitude. W_ext is the
/// work of the force on the accelerometer at the exciter, or on the observed motion where there is
/// none. u is what the vibrometer shows, or the kinematics with the axial compliance [AR14 (13)].
/// Standard deviations come from the scatter over the cycles. The secant stiffness is that of the
/// loop that the joint's force and displacement draw, as if u were harmonic,
///
///     k_eq = (1/πA) ∮ F_joint cos θ dθ,     u = A cos θ about its middle;
///
/// the force follows from the balance of the structure at the measured phase, not from the setting
/// of the drive. An error of the rig's first frequency moves it as a whole, which its standard
/// deviation does not contain. To its standard deviation is added what the mean tension by the
/// shortening may do, which no sensor sees.
///
/// Flags of D and k_eq: `inner_reversals`, `dissipation_negative`, `dissipation_in_noise` (D below
/// three standard deviations), `dissipation_above_bound` (D > kA², which no Iwan joint reaches),
/// `secant_above_stuck` (k_eq > 1.1 k), `secant_not_positive` (then it is left out),
/// `energies_differ` (W_ext by coefficients and by samples, by more than three standard errors). Of
/// the rig: `model_misfit`, `vibrometer_mismatch`, `far_from_first_mode`. Of the record:
/// `force_distortion`, `phase_unsteady`, `spike`, `few_cycles` (below 10), `uneven_sampling`, and
/// those of signal_quality() and fit_fourier().
class Reducer {
 public:
  /// @throws InputError  as check_rig() and stick_state(), and naming an option out of range.
  explicit Reducer(Rig rig, ReductionOptions options = {});

  /// The level that a record holds.
  /// @throws InputError  naming the source: a channel is missing, of another unit or length, there
  ///                     is no steady vibration in it (and why not).
  [[nodiscard]] ReducedLevel reduce(const Recording& recording) const;

  /// The rig of the records.
  [[nodiscard]] const Rig& rig() const { return rig_; }
  /// The modes that the reduction works with.
  [[nodiscard]] const StickState& state() const { return state_; }
  /// The options, as given.
  [[nodiscard]] const ReductionOptions& options() const { return options_; }

 private:
  Rig rig_;
  ReductionOptions options_;
  StickState state_;
};

}  // namespace microslip
