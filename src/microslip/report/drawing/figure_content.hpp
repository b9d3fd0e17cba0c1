// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// @file
/// The contents of a figure, apart from how it is drawn: on paper by gnuplot (gnuplot), on a page
/// by its scripts (html_report). Values are drawn as they are given: a caller who wants µm
/// on an axis scales the data and names µm as its unit. Texts are UTF-8 and shown as they are,
/// without markup.

namespace microslip {

/// Colours that people with any colour vision distinguish (Okabe and Ito), as indices: blue,
/// vermilion, bluish green, reddish purple, orange, sky blue, black, grey. Larger indices start
/// again.
inline constexpr int kColours = 8;
inline constexpr int kBlue = 0;        ///< `#0072b2`
inline constexpr int kVermillion = 1;  ///< `#d55e00`
inline constexpr int kGreen = 2;       ///< `#009e73`
inline constexpr int kPurple = 3;      ///< `#cc79a7`
inline constexpr int kOrange = 4;      ///< `#e69f00`
inline constexpr int kSkyBlue = 5;     ///< `#56b4e9`
inline constexpr int kBlack = 6;       ///< `#000000`
inline constexpr int kGrey = 7;        ///< `#707070`

/// The range of an axis, in the unit of the data.
struct AxisRange {
  double from = 0.0;  ///< its lower end
  double to = 1.0;    ///< > from
};

/// One axis of a figure.
struct FigureAxis {
  std::string label = {};               ///< without its unit: "slip force f*"
  std::string unit = {};                ///< "N"; "1" for a number; may be empty
  bool log = false;                     ///< to base 10; on a page, at first
  bool log_switch = false;              ///< lets the reader of a page change that
  bool degrees = false;                 ///< linear, with ticks at multiples of 15, 45 or 90
  std::optional<AxisRange> range = {};  ///< ≥ 1e-100 where log; without one, what the layers cover
};

/// "slip force f* [N]"; the label alone where there is no unit.
[[nodiscard]] std::string axis_text(const FigureAxis& axis);

/// Style of a line.
enum class LineStyle { kSolid, kDashed, kDotted, kDashDotted, kLongDashed };

/// Colour, style and width of a line.
struct Stroke {
  int colour = kBlue;                   ///< ≥ 0
  LineStyle style = LineStyle::kSolid;  ///< drawn through or broken
  double width = 1.8;                   ///< px of a picture at its nominal size; > 0
};

// Of all layers but markers: layers with the same `legend` share its entry, an empty one keeps a
// layer out of it. `name` is the full text where the reader of a page points at the layer; empty
// where it would repeat the legend. A layer that is not `shown` is on a page alone, where the
// reader turns it on.

/// A line through the points, in their order.
struct LineLayer {
  std::vector<double> x = {};  ///< in the unit of the axis
  std::vector<double> y = {};  ///< one per x
  std::string legend = {};     ///< see above
  Stroke stroke = {};          ///< of the line
  std::string name = {};       ///< see above
  bool shown = true;           ///< see above
};

/// A line whose last point is joined to the first: a hysteresis loop.
struct LoopLayer {
  std::vector<double> x = {};  ///< in the unit of the axis
  std::vector<double> y = {};  ///< one per x
  std::string legend = {};     ///< see above
  Stroke stroke = {};          ///< of the line
  std::string name = {};       ///< see above
  bool shown = true;           ///< see above
};

/// Marks, circles for the first colour and other shapes for the next ones, with bars from x −
/// x_error to x + x_error and from y − y_error to y + y_error.
struct PointLayer {
  std::vector<double> x = {};        ///< in the unit of the axis
  std::vector<double> y = {};        ///< one per x
  std::vector<double> x_error = {};  ///< none, or one per x, ≥ 0
  std::vector<double> y_error = {};  ///< none, or one per x, ≥ 0
  std::string legend = {};           ///< see above
  int colour = kBlue;                ///< ≥ 0
  double size = 1.0;                 ///< of the marks on paper, relative; > 0
  bool open = false;                 ///< on paper, outlines through which a line can be seen
  std::string name = {};             ///< see above
  bool shown = true;                 ///< see above
};

/// The translucent area between `lower` and `upper`.
struct BandLayer {
  std::vector<double> x = {};      ///< in the unit of the axis
  std::vector<double> lower = {};  ///< one per x
  std::vector<double> upper = {};  ///< one per x, ≥ lower
  std::string legend = {};         ///< see above
  int colour = kBlue;              ///< ≥ 0
  std::string name = {};           ///< see above
  bool shown = true;               ///< see above
};

/// Bars from the axis up to y at whole numbers: harmonics. Those of several layers at one x stand
/// side by side.
struct BarLayer {
  std::vector<double> x = {};  ///< whole numbers
  std::vector<double> y = {};  ///< one per x
  std::string legend = {};     ///< see above
  int colour = kBlue;          ///< ≥ 0
  std::string name = {};       ///< see above
  bool shown = true;           ///< see above
};

/// A vertical line across the figure, with a label above it; on a page it is the legend too.
struct MarkerLayer {
  double x = 0.0;          ///< in the unit of the axis
  std::string label = {};  ///< above the line; may be empty
  Stroke stroke = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2};  ///< of the line
};

/// Anything that can be drawn on a pair of axes.
using Layer = std::variant<LineLayer, LoopLayer, PointLayer, BandLayer, BarLayer, MarkerLayer>;

/// Place of the legend. Below and on the right it covers no data, however long it is.
enum class Legend { kBelow, kRight, kTopLeft, kTopRight, kBottomLeft, kBottomRight, kNone };

/// One pair of axes and its layers, the first one at the back.
///
/// On a logarithmic axis zero and negative values, all below 1e-100, have no place: points there
/// are left out, lines and bands break, and the lower edge of a band or bar that reaches them goes
/// to the end of the axis.
struct Figure {
  std::string title = {};          ///< above the figure; may be empty
  std::string subtitle = {};       ///< below the title, smaller; may be empty
  std::string caption = {};        ///< what is to be seen, a sentence or two; below it on a page
  FigureAxis x = {};               ///< the horizontal one
  FigureAxis y = {};               ///< the vertical one
  std::vector<Layer> layers = {};  ///< from back to front; one at least that is no marker
  Legend legend = Legend::kBelow;  ///< where it goes
};

/// Figures side by side under one title, row by row. The last row may be short.
struct FigureGrid {
  std::string title = {};           ///< above all panels; may be empty
  std::size_t columns = 2;          ///< ≥ 1
  std::vector<Figure> panels = {};  ///< row by row; one at least
};

/// A layer's entry in the legend, the label of a marker.
[[nodiscard]] const std::string& legend_of(const Layer& layer);

/// Its name, or its legend where it has none.
[[nodiscard]] const std::string& name_of(const Layer& layer);

/// Whether a layer is shown at first; a marker always is.
[[nodiscard]] bool is_shown(const Layer& layer);

}  // namespace microslip
