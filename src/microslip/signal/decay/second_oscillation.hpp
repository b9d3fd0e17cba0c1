// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/signal/decay/decay_walk.hpp"

/// @file
/// A second oscillation so near the mode that no window separates the two: a mode close by, or a
/// steady tone. Internal to signal.
///
/// A joint makes the decay rate and the frequency of a mode smooth functions of its amplitude. A
/// second oscillation does not: it beats with the mode at a constant difference of frequencies, or
/// outlasts it. Z(t), the transform at the mode's frequency of short tapered windows one behind the
/// other, is for two damped oscillations, whatever the taper,
///
///     Z(t) = c₁e^{−δ₁t} + c₂e^{(−δ₂ + iΔ)t},
///
/// and for a mode with a joint c₁e^{x + iθ}, ẋ = −δ(x), θ̇ = ω(x) − ω₀. Both are fitted, δ and ω
/// cubic in x, which has more unknowns. There is a second oscillation where the residual of two is
/// only noise and that of one mode clearly more.
///
/// Where neither does, δ and ω of a mode with a joint are fitted (OscillationModel::joint) with a
/// damped oscillation beside it: a mode without joints. It is subtracted from the signal where it
/// explains nearly all that the mode alone leaves.

namespace microslip {

/// Two damped oscillations: the mode, and another one beside it.
struct SecondOscillation {
  bool steady = false;        ///< a tone, which does not decay
  double omega = 0.0;         ///< of the second oscillation, rad/s
  double decay = 0.0;         ///< δ₂, 1/s; 0 of a tone
  double begin = 0.0;         ///< s from the first sample
  double amplitude = 0.0;     ///< of the second at `begin`, in the unit of the signal
  double ratio = 0.0;         ///< over that of the mode there
  double phase = 0.0;         ///< of the second at `begin`, rad
  bool beside_joint = false;  ///< beside a mode whose frequency moves: it can be subtracted

  double mode_amplitude = 0.0;  ///< of the mode at `begin`, in the unit of the signal
  double mode_omega = 0.0;      ///< rad/s
  double mode_decay = 0.0;      ///< δ₁, 1/s; above 0
  double length = 0.0;          ///< T of the windows of Z, s

  /// The window of the mode alone; without covariance and other modes.
  [[nodiscard]] DecayWindow mode_at(double time) const;
  /// The second oscillation at a time, s from the first sample, in the unit of the signal.
  [[nodiscard]] double value_at(double time) const;
};

/// The second oscillation of a decay; none where a smooth decay of one mode explains it as well.
/// @param windows         of the walk, with one at least.
/// @param noise_variance  of a sample.
/// @param before          the record before the blow; may be empty. A tone is in it as well.
[[nodiscard]] std::optional<SecondOscillation> find_second_oscillation(
    const DecayTask& task, std::span<const DecayWindow> windows, double noise_variance,
    std::span<const double> before);

/// Relative shift of ζ of a window by the second oscillation.
[[nodiscard]] double relative_shift(const SecondOscillation& second, const DecayWindow& window,
                                    const MeasuredMotion& measured);

/// Adds to the standard deviations what the second oscillation moves the windows by, also where
/// that is too little to be flagged.
void add_shifts(const SecondOscillation& second, std::span<const DecayWindow> windows,
                const MeasuredMotion& measured, std::span<DecayPoint> points);

}  // namespace microslip
