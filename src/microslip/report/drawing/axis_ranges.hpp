// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/drawing/figure.hpp"

/// @file
/// Ranges of the axes of a figure. Internal to report.

namespace microslip {

struct AxisRanges {
  AxisRange x;
  AxisRange y;
};

/// The ranges that the figure asks for; where it does not, that of its layers and a little more,
/// from zero on where that is close. The figure must keep the rules of check_figure().
[[nodiscard]] AxisRanges axis_ranges(const Figure& figure);

/// Place of the value along the axis: 0 at its start, 1 at its end.
[[nodiscard]] double axis_fraction(const AxisRange& range, bool log, double value);

}  // namespace microslip
