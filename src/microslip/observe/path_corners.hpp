// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace microslip {

/// A place where the velocity of a path jumps: a turn or the end of a hold at constant speed.
/// Filters and controllers round it over few samples.
struct PathCorner {
  double at = 0.0;        ///< between samples, in samples from the first
  double change = 0.0;    ///< of the velocity, m per sample
  double rounding = 0.0;  ///< standard deviation of the mean that rounds it, samples; 0: sharp

  /// The part of the path with this corner, t samples from it: ½ change·|t| as the mean over normal
  /// deviations s = `rounding` of t,
  ///
  ///     ½ change (t erf(t/(√2 s)) + √(2/π) s exp(−t²/(2s²))),    m.
  [[nodiscard]] double part(double t) const;

  /// The same, faded out from a quarter of `reach` on; beyond the corner all of its derivatives are
  /// continuous, m.
  [[nodiscard]] double value(double t, double reach) const;
};

/// Corners of a path with noise, by time. A corner stands out of any smooth path: within a window a
/// cubic with a corner leaves less than a polynomial with as many coefficients does, by more than
/// noise would, and nothing but noise (twice its variance over the window at most) or a hundredth
/// of what that leaves. Within ±3.5 samples of its place it leaves noise, too, or, as root of the
/// sum of squares, a twentieth of what the velocity changes in a sample. Windows of ±4 samples
/// and of ±8 means of 1, 2, 4, … samples are searched; the place is found between samples. Where a
/// sharp corner leaves more beside its place than noise, it is taken as rounded, by what fits best
/// up to 3 samples; a corner that is rounded over more is part of the smooth path.
///
/// The noise for these decisions is by the median of differences of order 2, 4 or 6, the smallest,
/// which a few corners do not change.
/// @param path  m, evenly spaced in time; finite.
[[nodiscard]] std::vector<PathCorner> path_corners(std::span<const double> path);

/// The reach of the part of each corner, in samples: to its nearer neighbour, 16 at least; of a
/// single one `size`.
[[nodiscard]] std::vector<double> reach_of_corners(const std::vector<PathCorner>& corners,
                                                   double size);

}  // namespace microslip
