// SPDX-License-Identifier: MIT
#include "microslip/report/static_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace microslip {
namespace {

std::string axis_text(const ReportAxis& axis) {
  return fmt::format("{} [{}]", axis.label, axis.unit);
}

FigureAxis figure_axis(const ReportAxis& axis) {
  return {.label = axis_text(axis), .log = axis.log, .range = axis.log ? std::nullopt : axis.range};
}

/// From and to of the points of a trace without a gap between them.
std::vector<std::pair<std::size_t, std::size_t>> runs(const std::vector<double>& y) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!std::isfinite(y[i])) continue;
    if (i == 0 || !std::isfinite(y[i - 1])) found.emplace_back(i, i);
    ++found.back().second;
  }
  return found;
}

std::vector<double> part(const std::vector<double>& values, std::size_t from, std::size_t to) {
  if (values.empty()) return {};
  return {values.begin() + static_cast<std::ptrdiff_t>(from),
          values.begin() + static_cast<std::ptrdiff_t>(to)};
}

Layer layer_of(const ReportTrace& trace, std::size_t from, std::size_t to,
               const std::string& legend) {
  std::vector<double> x = part(trace.x, from, to);
  std::vector<double> y = part(trace.y, from, to);
  switch (trace.kind) {
    case TraceKind::kLine:
      return LineLayer{x, y, legend, trace.stroke};
    case TraceKind::kLoop:
      return LoopLayer{x, y, legend, trace.stroke};
    default:
      break;
  }
  return PointLayer{.x = x,
                    .y = y,
                    .y_error = part(trace.y_std, from, to),
                    .legend = legend,
                    .colour = trace.stroke.colour,
                    .size = 0.9};
}

/// Hundreds of marks cover each other, and each is many bytes of a picture.
ReportTrace thinned(const ReportTrace& trace) {
  constexpr std::size_t kMost = 100;
  if (trace.kind != TraceKind::kPoints || trace.x.size() <= kMost) return trace;
  const std::size_t step = (trace.x.size() + kMost - 1) / kMost;
  ReportTrace thin = trace;
  thin.name = fmt::format("{}, one of {} points", legend_of(trace), step);
  thin.group.clear();
  for (auto* values : {&thin.x, &thin.y, &thin.y_std}) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values->size(); i += step) (*values)[kept++] = (*values)[i];
    values->resize(kept);
  }
  return thin;
}

/// @param named  gets what it is called in the legend, where that is not there yet.
void add_layers(const ReportTrace& trace, std::set<std::string>& named,
                std::vector<Layer>& layers) {
  if (trace.kind == TraceKind::kMarker) {
    layers.emplace_back(MarkerLayer{.x = trace.x[0], .label = trace.name});
    return;
  }
  if (trace.kind == TraceKind::kBand) {
    layers.emplace_back(
        BandLayer{trace.x, trace.lower, trace.upper, trace.name, trace.stroke.colour});
    return;
  }
  for (const auto& [from, to] : runs(trace.y)) {
    const bool is_new = named.insert(legend_of(trace)).second;
    layers.push_back(layer_of(trace, from, to, is_new ? legend_of(trace) : ""));
  }
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

std::string trace_text(const ReportTrace& trace, const ReportFigure& figure) {
  if (trace.kind == TraceKind::kMarker) {
    return fmt::format("{} at {:.3g} {}", trace.name, trace.x[0], figure.x.unit);
  }
  const bool band = trace.kind == TraceKind::kBand;
  const double lowest = range_of(band ? trace.lower : trace.y).first;
  const double highest = range_of(band ? trace.upper : trace.y).second;
  if (lowest > highest) return trace.name + " without a value";
  return fmt::format("{} from {:.3g} to {:.3g} {}", trace.name, lowest, highest, figure.y.unit);
}

/// Those at one x stand side by side.
void add_bars(const std::vector<const ReportTrace*>& traces, std::vector<Layer>& layers) {
  constexpr double kOfAStep = 0.76;
  const double width = kOfAStep / static_cast<double>(traces.size());
  double left = -0.5 * kOfAStep;
  for (const ReportTrace* trace : traces) {
    std::string legend = trace->name;
    for (std::size_t i = 0; i < trace->x.size(); ++i) {
      const double height = trace->y[i];
      if (!std::isfinite(height)) continue;
      const std::vector<double> x = {trace->x[i] + left, trace->x[i] + left + width};
      layers.emplace_back(BandLayer{x, {0.0, 0.0}, {height, height}, legend, trace->stroke.colour});
      layers.emplace_back(LineLayer{x, {height, height}, "", {.colour = trace->stroke.colour}});
      legend.clear();
    }
    left += width;
  }
}

}  // namespace

Figure static_picture(const ReportFigure& figure) {
  Figure picture;
  picture.x = figure_axis(figure.x);
  picture.y = figure_axis(figure.y);
  std::set<std::string> named;
  std::vector<const ReportTrace*> bars;
  for (const ReportTrace& trace : figure.choices.at(figure.chosen).traces) {
    if (!trace.shown) continue;
    if (trace.kind == TraceKind::kBars) {
      bars.push_back(&trace);
    } else {
      add_layers(thinned(trace), named, picture.layers);
    }
  }
  add_bars(bars, picture.layers);
  return picture;
}

std::string picture_text(const ReportFigure& figure) {
  const ReportChoice& choice = figure.choices.at(figure.chosen);
  std::string text =
      fmt::format("{}: {} over {}", figure.title, axis_text(figure.y), axis_text(figure.x));
  if (!choice.name.empty()) text += fmt::format(", {}", choice.name);
  text += ".";
  for (const ReportTrace& trace : choice.traces) {
    if (trace.shown) text += fmt::format(" {}.", trace_text(trace, figure));
  }
  return text;
}

}  // namespace microslip
