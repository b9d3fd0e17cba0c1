// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// @file
/// What a figure shows, apart from how it is drawn (report/gnuplot). Values are drawn as they are
/// given: a caller who wants µm on an axis scales the data and says µm in the label. Texts are
/// UTF-8 and shown as they are, without markup.

namespace microslip {

/// Colours that people with any colour vision tell apart (Okabe and Ito), as indices: blue,
/// vermillion, bluish green, reddish purple, orange, sky blue, black, grey. Larger indices start
/// again.
inline constexpr int kColours = 8;
inline constexpr int kBlue = 0;
inline constexpr int kVermillion = 1;
inline constexpr int kGreen = 2;
inline constexpr int kPurple = 3;
inline constexpr int kOrange = 4;
inline constexpr int kSkyBlue = 5;
inline constexpr int kBlack = 6;
inline constexpr int kGrey = 7;

/// From one end of an axis to the other, in the unit of the data.
struct AxisRange {
  double from = 0.0;
  double to = 1.0;  ///< > from
};

struct FigureAxis {
  std::string label = {};               ///< with the unit: "slip force f* [N]"
  bool log = false;                     ///< to base 10
  std::optional<AxisRange> range = {};  ///< ≥ 1e-100 where log; without one, what the layers cover
};

enum class LineStyle { kSolid, kDashed, kDotted };

struct Stroke {
  int colour = kBlue;  ///< ≥ 0
  LineStyle style = LineStyle::kSolid;
  double width = 1.8;  ///< px of a picture at its nominal size; > 0
};

/// A line through the points, in their order. An empty `legend` keeps a layer out of the legend.
struct LineLayer {
  std::vector<double> x;
  std::vector<double> y;  ///< one an x
  std::string legend = {};
  Stroke stroke = {};
};

/// As a line, with the last point joined to the first: a hysteresis loop.
struct LoopLayer {
  std::vector<double> x;
  std::vector<double> y;  ///< one an x
  std::string legend = {};
  Stroke stroke = {};
};

/// Marks, circles for the first colour and other shapes for the next ones, with bars from x −
/// x_error to x + x_error and from y − y_error to y + y_error.
struct PointLayer {
  std::vector<double> x;
  std::vector<double> y;             ///< one an x
  std::vector<double> x_error = {};  ///< none, or one an x, ≥ 0
  std::vector<double> y_error = {};  ///< none, or one an x, ≥ 0
  std::string legend = {};
  int colour = kBlue;  ///< ≥ 0
  double size = 1.0;   ///< of the marks, relative; > 0
};

/// The translucent area between `lower` and `upper`.
struct BandLayer {
  std::vector<double> x;
  std::vector<double> lower;  ///< one an x
  std::vector<double> upper;  ///< one an x, ≥ lower
  std::string legend = {};
  int colour = kBlue;  ///< ≥ 0
};

/// A vertical line across the figure, with a label above it.
struct MarkerLayer {
  double x = 0.0;
  std::string label = {};
  Stroke stroke = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2};
};

using Layer = std::variant<LineLayer, LoopLayer, PointLayer, BandLayer, MarkerLayer>;

/// Where the legend goes. Below and on the right it covers no data, however long it is.
enum class Legend { kBelow, kRight, kTopLeft, kTopRight, kBottomLeft, kBottomRight, kNone };

/// One pair of axes and what is drawn on it, the first layer at the back.
///
/// On a logarithmic axis zero and negative values, all below 1e-100, have no place: points there
/// are left out, lines and bands break, and the lower edge of a band or bar that reaches them goes
/// to the end of the axis.
struct Figure {
  std::string title = {};
  std::string subtitle = {};
  FigureAxis x = {};
  FigureAxis y = {};
  std::vector<Layer> layers = {};
  Legend legend = Legend::kBelow;
};

/// Figures side by side under one title, row by row. The last row may be short.
struct FigureGrid {
  std::string title = {};
  std::size_t columns = 2;  ///< ≥ 1
  std::vector<Figure> panels = {};
};

/// Checks what the comments above demand, that all numbers are finite and at most 1e100 in
/// magnitude, that there is a layer other than a marker, and that a value is left to draw on each
/// logarithmic axis.
/// @throws InputError  naming the layer, counted from 0, and the value.
void check_figure(const Figure& figure);

/// Checks each panel, and that there is one.
/// @throws InputError  as above, naming the panel, counted from 0.
void check_figure(const FigureGrid& grid);

}  // namespace microslip
