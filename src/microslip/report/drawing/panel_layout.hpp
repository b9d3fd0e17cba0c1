// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/report/drawing/axis_ranges.hpp"
#include "microslip/report/drawing/axis_ticks.hpp"
#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/legend_layout.hpp"
#include "microslip/report/drawing/placed.hpp"

/// @file
/// Places of the parts of a figure, so that none covers another. gnuplot's own layout knows the
/// width of no text and lets long legends run over the axes or leaves them out. Internal to report.

namespace microslip {

/// The label above the vertical line of a marker.
struct PlacedMarker {
  std::size_t layer = 0;
  PlacedText label;
};

/// The number at a tick.
struct PlacedTick {
  TickLabel label;
  double x = 0.0;
  double y = 0.0;
  Side side = Side::kCentre;
};

struct PanelLayout {
  AxisRanges ranges;
  Ticks x_ticks;
  Ticks y_ticks;
  Box axes;
  std::vector<PlacedTick> numbers;  ///< of both axes
  std::vector<PlacedText> title;
  std::vector<PlacedText> subtitle;
  std::vector<PlacedText> x_label;
  std::vector<PlacedText> y_label;    ///< reads upwards
  std::vector<PlacedMarker> markers;  ///< those within the range
  std::vector<LegendEntry> legend;
  Box legend_box;  ///< around the legend where it lies inside the axes
};

/// Lays out a figure.
/// @param figure  must keep the rules of check_figure().
/// @param space   all that the figure may cover.
/// @param least   least distance of the axes from its edges; the parts at an edge move
///                along.
/// @throws InputError  where the texts leave no room for the axes.
[[nodiscard]] PanelLayout panel_layout(const Figure& figure, const Box& space,
                                       const Margins& least = {});

/// Distances of the axes from the edges.
[[nodiscard]] Margins margins_of(const PanelLayout& layout, const Box& space);

}  // namespace microslip
