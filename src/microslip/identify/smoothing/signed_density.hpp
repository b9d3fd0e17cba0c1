// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace microslip {

/// A density by (9) from measured dissipation, point by point. It is not limited to positive values
/// or to an area below 1: with strong noise or a varying normal load it is negative.
struct SignedDensity {
  std::vector<double> slip_force;  ///< f* = kA, N; increasing
  std::vector<double> density;     ///< φ(f*), 1/N; of the same length
  /// Standard deviation of φ, from that of D alone, 1/N; of the same length or empty (not known).
  std::vector<double> standard_deviation;
};

/// φ(kA) = D″(A)/(4k²A), 1/N. [AR14 (9)]
/// @param curvature  D″, J/m².
/// @param amplitude  A, m; > 0.
/// @param stiffness  k, N/m; > 0.
[[nodiscard]] double density_from_curvature(double curvature, double amplitude, double stiffness);

/// The rule on the stiffness k of a stuck joint. @throws InputError  unless positive and finite.
void check_stiffness(double stiffness);

}  // namespace microslip
