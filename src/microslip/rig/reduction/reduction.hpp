// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/reduced_level.hpp"
#include "microslip/rig/reduction/reduction_options.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// From a steady record to a level: the dissipation of the joint per cycle and its amplitude.

namespace microslip {

/// Reduces the records of one test. Shared by threads.
///
/// A record is fitted by Fourier series with a common fundamental; modal coordinates follow from
/// force and accelerations (ModalObserver), W_lin from them in the stick-state modes with their own
/// ω_i: the linear damping was identified there and does not change with amplitude. W_ext is the
/// work of the force on the accelerometer at the exciter, or on the observed motion where there is
/// none. u is that of the vibrometer, or of the kinematics with the axial compliance [AR14 (13)].
/// Standard deviations come from the scatter over the cycles. The secant stiffness is that of the
/// loop that the joint's force and displacement draw, as if u were harmonic,
///
///     k_eq = (1/πA) ∮ F_joint cos θ dθ,     u = A cos θ about its middle;
///
/// the force follows from the balance of the structure at the measured phase, not from the setting
/// of the drive. An error of the rig's first frequency moves it as a whole, which its standard
/// deviation does not contain. Its standard deviation includes the possible effect of the mean
/// tension by the shortening, which no sensor measures.
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

  /// The level of a record.
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
