// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/observe/path_corners.hpp"

namespace microslip {

/// A measured path without most of its noise.
struct SmoothedPath {
  std::vector<double> displacement = {};  ///< m; one per sample
  double noise = 0.0;                     ///< standard deviation of a measured sample, m
  double left = 0.0;                      ///< of it the part left in `displacement`, m
  std::vector<PathCorner> corners = {};  ///< jumps of the velocity, which stay as sharp as they are

  /// Turns smaller than this are those of noise, or of rounding, m.
  [[nodiscard]] double smallest_turn() const;
};

/// Removes the noise from a path: small turns caused by noise alone would be loops of their own,
/// and an error beside a reversal stays in all that follows. The spectrum of the noise is flat, and
/// its level that of the upper quarter of all frequencies, where a path that was sampled finely
/// enough has nothing else; each line is kept as far as it stands out of it, 1 − N/P with P
/// smoothed over its neighbours [Wiener filter, without phase]. Corners, whose harmonics a filter
/// would cut where they fall below the noise, are subtracted before and added again. A path that
/// fills its whole spectrum stays as it is, and so does one that ends beside noise of another
/// colour.
///
/// A joint is independent of rate, but its force follows the path as it was: forces must not be
/// smoothed as well, as their kinks contain the information sought.
/// @param displacement  m, evenly spaced in time; finite.
[[nodiscard]] SmoothedPath smooth_path(std::span<const double> displacement);

}  // namespace microslip
