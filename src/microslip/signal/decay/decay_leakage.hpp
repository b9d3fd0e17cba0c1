// SPDX-License-Identifier: MIT
#pragma once

#include <span>

/// @file
/// Leakage of other oscillations through the taper of a window into the decay of one. Internal to
/// signal.
///
/// An oscillation of r times the amplitude, d = ΔfT lines away, moves the decay that is fitted
/// under cos⁴ by at most
///
///     |Δ(δT)| = r ∫|s| … = r·31.8/(d(d² − 1)(d² − 4)),     d > 2
///
/// (the derivative of the taper's transform, 1.5 cos πd/(2π d(d² − 1)(d² − 4)), over
/// ∫s² cos⁴πs ds = 0.0075).

namespace microslip {

/// Another oscillation in addition to the mode, within a window.
struct BesideMode {
  double distance = 0.0;  ///< Hz, above 0
  double ratio = 0.0;     ///< of amplitudes, over that of the mode
};

/// Root of the sum of the squares of |Δ(δT)|, 1.
/// @param length  T, s.
[[nodiscard]] double decay_leakage(std::span<const BesideMode> beside, double length);

/// The shortest length in a range whose leakage is below a share of δT; the longest where none is.
/// @param decay  δ, 1/s, above 0.
[[nodiscard]] double length_for_leakage(std::span<const BesideMode> beside, double decay,
                                        double share, double shortest, double longest);

}  // namespace microslip
