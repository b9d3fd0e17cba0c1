// SPDX-License-Identifier: MIT
#include "microslip/report/document/harmonic_parts.hpp"

namespace microslip {

FigureAxis harmonic_axis(std::size_t first, std::size_t last) {
  return {.label = "harmonic",
          .unit = "1",
          .range = AxisRange{static_cast<double>(first) - 0.6, static_cast<double>(last) + 0.6}};
}

LineLayer one_percent(double from, double to) {
  return {
      {from, to}, {1.0, 1.0}, "1 %", {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}};
}

}  // namespace microslip
