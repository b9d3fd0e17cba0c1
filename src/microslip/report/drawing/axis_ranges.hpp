// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/drawing/figure.hpp"

/// @file
/// How far the axes of a figure reach. Internal to report.

namespace microslip {

struct AxisRanges {
  AxisRange x;
  AxisRange y;
};

/// The ranges that the figure asks for; where it does not, what its layers cover and a little more,
/// from zero on where that is near. The figure must keep the rules of check_figure().
[[nodiscard]] AxisRanges axis_ranges(const Figure& figure);

/// Where the value lies along the axis: 0 at its start, 1 at its end.
[[nodiscard]] double axis_fraction(const AxisRange& range, bool log, double value);

}  // namespace microslip
