// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/requirement.hpp"
#include "microslip/report/drawing/drawn.hpp"

namespace microslip {
namespace {

// What is beyond is no measurement, and no sum or power of it may leave the range of doubles.
constexpr double kLargest = 1e100;
// Length of a range relative to its ends; numbers at ticks have up to 15 digits.
constexpr double kShortestRange = 1e-9;

void check_number(const std::string& what, double value) {
  require(std::abs(value) <= kLargest, what, value, "must be finite, at most 1e100 in magnitude");
}

void check_colour(const std::string& layer, int colour) {
  require(colour >= 0, layer + ".colour", colour, "must not be negative");
}

void check_positive(const std::string& what, double value) {
  require(value > 0.0 && value <= kLargest, what, value, "must be positive and finite");
}

void check_stroke(const std::string& layer, const Stroke& stroke) {
  check_colour(layer, stroke.colour);
  check_positive(layer + ".stroke.width", stroke.width);
}

/// A column of a layer: finite numbers, as many as there are x.
void check_column(const std::string& layer, std::string_view name,
                  const std::vector<double>& column, std::size_t count, bool gaps = false) {
  const std::string what = fmt::format("{}.{}", layer, name);
  require(column.size() == count, what + ".size()", static_cast<double>(column.size()),
          fmt::format("must be the {} of x", count));
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (gaps && !std::isfinite(column[i])) continue;
    check_number(fmt::format("{}[{}]", what, i), column[i]);
  }
}

void check_x(const std::string& layer, const std::vector<double>& x) {
  require(!x.empty(), layer + ".x.size()", 0, "must be 1 or more", "Leave an empty layer out.");
  check_column(layer, "x", x, x.size());
}

void check_error(const std::string& layer, std::string_view name, const std::vector<double>& error,
                 std::size_t count) {
  if (error.empty()) return;
  check_column(layer, name, error, count);
  for (std::size_t i = 0; i < count; ++i) {
    require(error[i] >= 0.0, fmt::format("{}.{}[{}]", layer, name, i), error[i],
            "must not be negative");
  }
}

template <class LineOrLoop>
void check_layer(const std::string& name, const LineOrLoop& layer, bool gaps) {
  check_x(name, layer.x);
  check_column(name, "y", layer.y, layer.x.size(), gaps);
  check_stroke(name, layer.stroke);
}

void check_layer(const std::string& name, const PointLayer& layer, bool gaps) {
  check_x(name, layer.x);
  check_column(name, "y", layer.y, layer.x.size(), gaps);
  check_error(name, "x_error", layer.x_error, layer.x.size());
  check_error(name, "y_error", layer.y_error, layer.x.size());
  check_colour(name, layer.colour);
  check_positive(name + ".size", layer.size);
}

void check_layer(const std::string& name, const BandLayer& layer, bool /*gaps*/) {
  check_x(name, layer.x);
  check_column(name, "lower", layer.lower, layer.x.size());
  check_column(name, "upper", layer.upper, layer.x.size());
  for (std::size_t i = 0; i < layer.x.size(); ++i) {
    require(layer.upper[i] >= layer.lower[i], fmt::format("{}.upper[{}]", name, i), layer.upper[i],
            fmt::format("must not be below lower[{}] = {}", i, layer.lower[i]));
  }
  check_colour(name, layer.colour);
}

void check_layer(const std::string& name, const BarLayer& layer, bool gaps) {
  check_x(name, layer.x);
  check_column(name, "y", layer.y, layer.x.size(), gaps);
  for (std::size_t i = 0; i < layer.x.size(); ++i) {
    require(layer.x[i] == std::round(layer.x[i]), fmt::format("{}.x[{}]", name, i), layer.x[i],
            "must be a whole number");
  }
  check_colour(name, layer.colour);
}

void check_layer(const std::string& name, const MarkerLayer& layer, bool /*gaps*/) {
  check_number(name + ".x", layer.x);
  check_stroke(name, layer.stroke);
}

void check_axis(const std::string& name, const FigureAxis& axis) {
  if (!axis.range) return;
  check_number(name + ".range.from", axis.range->from);
  check_number(name + ".range.to", axis.range->to);
  const double largest = std::max(std::abs(axis.range->from), std::abs(axis.range->to));
  require(axis.range->to - axis.range->from > kShortestRange * largest, name + ".range.to",
          axis.range->to, fmt::format("must be larger than range.from = {}", axis.range->from));
  require(!axis.log || axis.range->from >= kSmallestOnLog, name + ".range.from", axis.range->from,
          "must be positive on a logarithmic axis");
}

void check_drawn(const std::string& prefix, const Figure& figure) {
  std::size_t shapes = 0;
  for (const Layer& layer : figure.layers) {
    shapes += is_shown(layer) && !std::holds_alternative<MarkerLayer>(layer) ? 1 : 0;
  }
  require(shapes > 0, prefix + "layers.size()", static_cast<double>(shapes),
          "a figure needs a line, a loop, points, a band or bars");
  if (!anything_drawn(figure)) {
    throw InputError(prefix + "layers", "no positive value",
                     "a logarithmic axis shows positive values only", "Make the axis linear.");
  }
}

void check_panel(const std::string& prefix, const Figure& figure) {
  check_axis(prefix + "x", figure.x);
  check_axis(prefix + "y", figure.y);
  check_layers(prefix, figure.layers, false);
  check_drawn(prefix, figure);
}

}  // namespace

void check_layers(const std::string& prefix, const std::vector<Layer>& layers, bool gaps) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string name = fmt::format("{}layers[{}]", prefix, i);
    std::visit([&](const auto& layer) { check_layer(name, layer, gaps); }, layers[i]);
  }
}

void check_figure(const Figure& figure) { check_panel("", figure); }

void check_figure(const FigureGrid& grid) {
  require(grid.columns >= 1, "columns", 0, "must be 1 or more");
  require(!grid.panels.empty(), "panels.size()", 0, "must be 1 or more");
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    check_panel(fmt::format("panels[{}].", i), grid.panels[i]);
  }
}

}  // namespace microslip
