// SPDX-License-Identifier: MIT
#include "microslip/report/document/static_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace microslip {
namespace {

/// Begin and end of the runs of finite values of a layer.
std::vector<std::pair<std::size_t, std::size_t>> runs(const std::vector<double>& y) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!std::isfinite(y[i])) continue;
    if (i == 0 || !std::isfinite(y[i - 1])) found.emplace_back(i, i);
    ++found.back().second;
  }
  return found;
}

/// Keeps every `step`-th of the values from `from` to `to`; an empty vector stays empty.
void cut(std::vector<double>& values, std::size_t from, std::size_t to, std::size_t step = 1) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = from; i < to; i += step) values[kept++] = values[i];
  values.resize(kept);
}

template <class LayerOfPoints>
void cut_all(LayerOfPoints& layer, std::size_t from, std::size_t to, std::size_t step = 1) {
  for (auto* values : {&layer.x, &layer.y}) cut(*values, from, to, step);
  if constexpr (requires { layer.y_error; }) {
    for (auto* values : {&layer.x_error, &layer.y_error}) cut(*values, from, to, step);
  }
}

/// Thins out marks: hundreds cover each other, and each is many bytes of a picture.
void thin(PointLayer& points) {
  constexpr std::size_t kMost = 100;
  if (points.x.size() <= kMost) return;
  const std::size_t step = (points.x.size() + kMost - 1) / kMost;
  points.legend += fmt::format(", one of {} points", step);
  cut_all(points, 0, points.x.size(), step);
}

/// Adds the layer as pieces without gaps.
void add_pieces(Layer layer, std::vector<Layer>& layers) {
  std::visit(
      [&](auto& concrete) {
        if constexpr (requires { concrete.y; }) {
          for (const auto& [from, to] : runs(concrete.y)) {
            auto piece = concrete;
            cut_all(piece, from, to);
            layers.emplace_back(std::move(piece));
          }
        } else {
          layers.emplace_back(std::move(concrete));
        }
      },
      layer);
}

std::pair<double, double> range_of(const std::vector<double>& values) {
  std::pair<double, double> range{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range = {std::min(range.first, value), std::max(range.second, value)};
  }
  return range;
}

std::string layer_text(const Layer& layer, const Figure& figure) {
  if (const auto* marker = std::get_if<MarkerLayer>(&layer)) {
    return fmt::format("{} at {:.3g} {}", marker->label, marker->x, figure.x.unit);
  }
  const auto [lowest, highest] = std::visit(
      [](const auto& concrete) -> std::pair<double, double> {
        if constexpr (requires { concrete.lower; }) {
          return {range_of(concrete.lower).first, range_of(concrete.upper).second};
        } else if constexpr (requires { concrete.y; }) {
          return range_of(concrete.y);
        } else {
          return {0.0, 0.0};
        }
      },
      layer);
  if (lowest > highest) return name_of(layer) + " without a value";
  return fmt::format("{} from {:.3g} to {:.3g} {}", name_of(layer), lowest, highest, figure.y.unit);
}

}  // namespace

Figure static_picture(const ReportFigure& figure) {
  Figure picture = figure.figure;
  picture.title.clear();
  picture.layers.clear();
  for (Layer layer : chosen_layers(figure)) {
    if (auto* points = std::get_if<PointLayer>(&layer)) thin(*points);
    add_pieces(std::move(layer), picture.layers);
  }
  return picture;
}

std::string picture_text(const ReportFigure& figure) {
  const Figure& drawn = figure.figure;
  std::string text =
      fmt::format("{}: {} over {}", drawn.title, axis_text(drawn.y), axis_text(drawn.x));
  if (!figure.choices.empty()) text += fmt::format(", {}", figure.choices.at(figure.chosen).name);
  text += ".";
  for (const Layer& layer : chosen_layers(figure)) {
    if (is_shown(layer)) text += fmt::format(" {}.", layer_text(layer, drawn));
  }
  return text;
}

}  // namespace microslip
