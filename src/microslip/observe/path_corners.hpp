// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace microslip {

/// A place where the velocity of a path jumps: a turn or the end of a hold at constant speed.
struct PathCorner {
  double at = 0.0;      ///< between samples, in samples from the first
  double change = 0.0;  ///< of the velocity, m per sample

  /// The part of the path with this corner: ½ change·|t|, t samples from the corner, that fades out
  /// from a quarter of `reach` on; beyond the corner all of its derivatives are continuous, m.
  [[nodiscard]] double value(double t, double reach) const;
};

/// Corners of a path with noise, by time. A corner stands out of any smooth path: within a window a
/// cubic with a corner leaves less than a polynomial with as many coefficients does, by more than
/// noise would, and nothing but noise or a hundredth of what that leaves. Windows of ±4 samples
/// and of ±8 means of 1, 2, 4, … samples are searched, and again without the corners that were
/// found, which hide others in their windows; the place is found between samples. A
/// corner that is rounded over more samples than its noise hides is part of the smooth path.
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
