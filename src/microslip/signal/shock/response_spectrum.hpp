// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace microslip {

/// The largest responses of single masses on springs and dashpots that a base shakes, over their
/// natural frequency.
struct ResponseSpectrum {
  std::vector<double> frequency;     ///< f, Hz
  std::vector<double> positive;      ///< max ẍ, m/s²: absolute acceleration of the mass; ≥ 0
  std::vector<double> negative;      ///< max −ẍ, m/s²; ≥ 0
  std::vector<double> displacement;  ///< max |z|, m: relative to the base

  /// The larger of the two, m/s²: "maximax".
  [[nodiscard]] std::vector<double> maximax() const;
};

/// The shock response spectrum [ISO 18431-4] of an acceleration that is linear between its times:
///
///     z̈ + 2ζω ż + ω² z = −a(t),   ẍ = z̈ + a,   ω = 2πf
///
/// from rest, over the record and a period of f after it without load. Each interval is solved in
/// closed form [Nigam & Jennings, Bull. Seism. Soc. Am. 59 (1969) 909] in steps of 1/(40f) at most;
/// peaks between them by a parabola through three, so that they are right to some 1e-5.
/// @param time          s; rising, two at least. @param acceleration  a, m/s²; one per time.
/// @param frequencies   f, Hz; > 0.
/// @param damping_ratio ζ, 1; from 0, below 1. Q = 10 is 0.05.
/// @throws InputError  naming what breaks a rule.
[[nodiscard]] ResponseSpectrum response_spectrum(std::span<const double> time,
                                                 std::span<const double> acceleration,
                                                 std::span<const double> frequencies,
                                                 double damping_ratio);

}  // namespace microslip
