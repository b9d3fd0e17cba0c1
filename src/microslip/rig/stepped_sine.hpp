// SPDX-License-Identifier: MIT
#pragma once

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

/// The level that a sweep holds, by its resonance_of() (sweep_resonance.hpp). There
///
///     W_ext = π |F_1| |A_1|/ω²,
///
/// and W_lin, A and k_eq follow as in Reducer, by the rig's modes. Flags: warnings_of() of the
/// resonance.
/// @throws InputError  as resonance_of(); where the phase does not pass a quarter turn; where
///                     the rig has more than one accelerometer, or it is not at the exciter.
[[nodiscard]] ReducedLevel reduce_stepped_sine(const Reducer& reducer, const SteppedSine& sweep);

}  // namespace microslip
