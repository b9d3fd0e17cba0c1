// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/text_layout.hpp"

/// @file
/// The ticks of an axis and the numbers at them. Internal to report.

namespace microslip {

/// A number at a tick: "0.05", "−3", "2.5×10" with the exponent "−6".
struct TickLabel {
  double value = 0.0;
  std::string text;
  std::string exponent;  ///< raised; empty where there is none
};

[[nodiscard]] double label_width(const TickLabel& label, Font font);

struct Ticks {
  std::vector<TickLabel> labelled;
  std::vector<double> minor;
};

/// Ticks whose labels do not touch. On a linear axis they are equidistant. On a logarithmic axis
/// they are the powers of ten, thinned out where there are many; where there are less than three,
/// other multiples of them come in.
/// @param length    of the axis, px.
/// @param vertical  the labels are above each other, not side by side.
/// @param degrees   ticks of a linear axis at parts and multiples of a right angle.
[[nodiscard]] Ticks axis_ticks(const AxisRange& range, bool log, double length, bool vertical,
                               Font font, bool degrees = false);

}  // namespace microslip
