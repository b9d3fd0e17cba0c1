// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

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

}  // namespace microslip
