// SPDX-License-Identifier: MIT
#include "microslip/report/harmonic_bars.hpp"

namespace microslip {

void add_harmonic_bars(Figure& panel, std::span<const double> heights, BarSide side, int colour,
                       const std::string& legend) {
  constexpr double kWidth = 0.34;
  constexpr double kGap = 0.02;
  const double from = side == BarSide::kLeft ? -kGap - kWidth : kGap;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double left = static_cast<double>(i + 1) + from;
    const double height = heights[i];
    panel.layers.emplace_back(BandLayer{
        {left, left + kWidth}, {0.0, 0.0}, {height, height}, i == 0 ? legend : "", colour});
    panel.layers.emplace_back(
        LineLayer{{left, left + kWidth}, {height, height}, "", {.colour = colour, .width = 2.0}});
  }
}

FigureAxis harmonic_axis(std::size_t count) {
  return {.label = "harmonic", .range = AxisRange{0.4, static_cast<double>(count) + 0.6}};
}

}  // namespace microslip
