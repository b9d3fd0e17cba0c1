// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace microslip {

/// Standard deviation of the scatter of y about a curve that is straight over three neighbouring
/// points: each point against the straight line through its neighbours. It needs no model of the
/// curve. Curvature between neighbours counts as scatter, but the median of the deviations keeps a
/// few strongly curved places from counting.
/// [Gasser, Sroka & Jennen-Steinmetz, Biometrika 73 (1986) 625, with a median in place of the mean]
/// @param x  strictly increasing; at least 3 points. @param y  of the length of x.
/// @return   in the unit of y.
[[nodiscard]] double scatter_about_neighbours(std::span<const double> x, std::span<const double> y);

/// The same about a curve that may bend: each point against the cubic through the two neighbours on
/// either side, where there are nine points or more; against the straight line of fewer. Over the
/// standard deviations of the points, so that 1 is what they state.
/// @param x      strictly increasing; at least 3 points.
/// @param y      of the length of x.
/// @param sigma  of each y; > 0.
[[nodiscard]] double scatter_about_curve(std::span<const double> x, std::span<const double> y,
                                         std::span<const double> sigma);

}  // namespace microslip
