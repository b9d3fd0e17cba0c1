// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/report/drawing/figure_content.hpp"

/// @file
/// The part of a layer that is drawn on given axes. Internal to report.

namespace microslip {

/// Values below this count as zero on a logarithmic axis.
inline constexpr double kSmallestOnLog = 1e-100;

/// Half of the width of all bars at a whole number.
inline constexpr double kHalfOfBars = 0.38;

/// A point of a line or of marks with the ends of its bars, the two edges of a band at x, or the
/// room of the bars at x from the axis up to y. On a
/// logarithmic axis the low ends may be below kSmallestOnLog: they go to the end of the axis.
struct Place {
  double x;
  double y;
  double x_low;
  double x_high;
  double y_low;
  double y_high;
};

/// Places that follow each other without a gap.
using Piece = std::vector<Place>;

/// The layer without points that have no place on a logarithmic axis, split there; a loop ends
/// where it begins. Nothing for a marker and for a hidden layer. The layer must keep the rules of
/// check_figure().
[[nodiscard]] std::vector<Piece> drawn_pieces(const Layer& layer, bool log_x, bool log_y);

/// Whether there is a place in any layer.
[[nodiscard]] bool anything_drawn(const Figure& figure);

}  // namespace microslip
