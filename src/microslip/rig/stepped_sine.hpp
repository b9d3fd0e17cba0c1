// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/rig/reduction.hpp"

namespace microslip {

/// A stepped-sine sweep through a resonance, of which the first harmonics were kept: one entry a
/// step, all vectors of one length.
struct SteppedSine {
  std::string source;                ///< its file, for messages
  std::vector<double> frequency;     ///< Hz; above 0
  std::vector<double> force;         ///< |F_1|, N; above 0
  std::vector<double> acceleration;  ///< |A_1| at the exciter, m/s²; above 0
  std::vector<double>
      phase;  ///< of the acceleration against the force, rad; either sign throughout
};

/// Checks the ranges above.
/// @throws InputError  naming the source, the column and the value that breaks a rule.
void check_stepped_sine(const SteppedSine& sweep);

/// Where the phase of a sweep passes a quarter turn, either way: in phase resonance.
struct SweepResonance {
  double frequency = 0.0;     ///< Hz
  double force = 0.0;         ///< |F_1| there, N
  double acceleration = 0.0;  ///< |A_1| there, m/s²
  std::size_t passages = 1;   ///< of a quarter turn in the sweep
};

/// Logarithms of amplitudes and the frequency are taken linear in the phase between the two steps
/// beside it; of several passages that of the largest acceleration.
/// @return nothing where the phase does not pass a quarter turn.
/// @throws InputError  as check_stepped_sine().
[[nodiscard]] std::optional<SweepResonance> resonance_of(const SteppedSine& sweep);

/// The level that a sweep holds, by its resonance_of(). There
///
///     W_ext = π |F_1| |A_1|/ω²,
///
/// and W_lin, A and k_eq follow as in Reducer, by the rig's modes. Where the phase passes a quarter
/// turn more than once, the passage of the largest acceleration counts, with the flag
/// `several_resonances`.
/// @throws InputError  as check_stepped_sine(); where the phase does not pass a quarter turn; where
///                     the rig has more than one accelerometer, or it is not at the exciter.
[[nodiscard]] ReducedLevel reduce_stepped_sine(const Reducer& reducer, const SteppedSine& sweep);

}  // namespace microslip
