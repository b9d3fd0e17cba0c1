// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace microslip {

/// Standard deviation of the noise of a path, m: by the median of its differences of order 2, 4 or
/// 6, the smallest, which a few corners do not change; rounding at least.
/// @param path  m, evenly spaced in time; 7 samples at least.
[[nodiscard]] double noise_of_path(std::span<const double> path);

/// A path at its first sample without most of the noise, m: by the straight line or parabola
/// through as many samples as follow it; the sample itself where too few do.
/// @param path  m, evenly spaced in time; 7 samples at least.
[[nodiscard]] double first_without_noise(std::span<const double> path);

}  // namespace microslip
