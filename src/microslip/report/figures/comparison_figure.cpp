// SPDX-License-Identifier: MIT
#include "microslip/report/figures/comparison_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/gather.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip {
namespace {

constexpr int kOutsideColour = kVermillion;
constexpr int kInsideColour = kBlack;

/// The name in words of an axis.
std::string axis_words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// The values of a curve that can be drawn, by rising place.
std::vector<std::size_t> drawn_order(const ComparedCurve& curve) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (std::isfinite(curve.at[i]) && curve.compares(i)) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return curve.at[i]; });
  return order;
}

/// The measured values inside of the band, or outside; without a band all are inside.
PointLayer measured_points(const ComparedCurve& curve, const std::vector<std::size_t>& order,
                           bool inside) {
  const char* const legend = !curve.has_band() ? "measured"
                             : inside          ? "measured, inside"
                                               : "measured, outside";
  PointLayer points{.legend = legend, .colour = inside ? kInsideColour : kOutsideColour};
  points.size = 0.8;
  points.open = inside;
  for (const std::size_t i : order) {
    if ((!curve.has_band() || curve.inside(i)) != inside) continue;
    points.x.push_back(curve.at[i]);
    points.y.push_back(curve.measured[i]);
    if (curve.measured_std.empty()) continue;
    const double deviation = curve.measured_std[i];
    points.y_error.push_back(std::isfinite(deviation) ? deviation : 0.0);
  }
  return points;
}

/// Adds the quantity of the curve at the peak, measured and predicted.
void add_peak(const ComparedTest& test, const ComparedCurve& curve, Figure& panel) {
  const auto at_peak = [&](const std::string& quantity) {
    return std::ranges::find_if(test.curves, [&](const ComparedCurve& other) {
      return other.part == TestPart::kPeak && other.quantity == quantity;
    });
  };
  const auto height = at_peak(curve.quantity);
  const auto frequency = at_peak("frequency");
  if (height == test.curves.end() || frequency == test.curves.end()) return;
  if (!height->compares(0) || !frequency->compares(0)) return;
  panel.layers.emplace_back(PointLayer{.x = {frequency->measured[0]},
                                       .y = {height->measured[0]},
                                       .legend = "measured peak",
                                       .colour = kGreen,
                                       .size = 1.6});
  panel.layers.emplace_back(PointLayer{.x = {frequency->predicted[0]},
                                       .y = {height->predicted[0]},
                                       .legend = "predicted peak",
                                       .colour = kPurple,
                                       .size = 1.6});
}

FigureAxis& y_axis(Figure& panel) { return panel.y; }
FigureAxis& y_axis(ReportFigure& figure) { return figure.figure.y; }

/// @param panel  a Figure, or a ReportFigure.
template <typename Panel>
void show_quantity(const ComparedCurve& curve, Panel& panel) {
  if (curve.dimension == kAngle) {
    show_y(panel, axis_words(curve.quantity), "°");
    y_axis(panel).degrees = true;
  } else if (curve.quantity == "damping_ratio") {
    show_y(panel, "damping ratio ζ", "%");
  } else {
    show_y(panel, axis_words(curve.quantity), si_unit(curve.dimension));
  }
  show_x(panel, axis_words(curve.axis), si_unit(curve.axis_dimension));
}

/// A logarithmic axis suits amplitudes over more than a decade and a half.
bool suits_log(const std::vector<double>& rising) {
  constexpr double kFar = 30.0;
  return rising.front() > 0.0 && rising.back() > kFar * rising.front();
}

/// Title without the folder of the file, which may be long: "sweeps.mat:FRdata(1)".
std::string title_of(const ComparedTest& test) {
  const std::size_t file = std::min(test.source.find(':'), test.source.size());
  return std::string(file_name(std::string_view(test.source).substr(0, file))) +
         test.source.substr(file);
}

/// Layers of a curve, in SI.
Figure curve_layers(const ComparedTest& test, const ComparedCurve& curve,
                    const std::vector<std::size_t>& order) {
  Figure panel{.title = title_of(test)};
  const std::vector<double> at = gather(curve.at, order);
  if (curve.has_band()) {
    panel.layers.emplace_back(BandLayer{at, gather(curve.lower, order), gather(curve.upper, order),
                                        "band of draws", kBlue});
  }
  panel.layers.emplace_back(
      LineLayer{at, gather(curve.predicted, order), "predicted", {.colour = kBlue}});
  for (const bool inside : {true, false}) {
    PointLayer points = measured_points(curve, order, inside);
    if (!points.x.empty()) panel.layers.emplace_back(std::move(points));
  }
  add_peak(test, curve, panel);
  panel.x.log = suits_log(at);
  return panel;
}

Figure curve_panel(const ComparedTest& test, const ComparedCurve& curve,
                   const std::vector<std::size_t>& order) {
  Figure panel = curve_layers(test, curve, order);
  show_quantity(curve, panel);
  return panel;
}

/// Curves of one quantity over one axis, of all tests that have it.
struct CurveGroup {
  const ComparedCurve* first;
  ReportFigure figure;
};

bool is_of_group(const CurveGroup& group, const ComparedCurve& curve) {
  return group.first->quantity == curve.quantity && group.first->axis == curve.axis &&
         group.first->dimension == curve.dimension &&
         group.first->axis_dimension == curve.axis_dimension;
}

/// A name that no other choice has.
std::string choice_name(const std::string& title, const std::vector<FigureChoice>& choices) {
  std::string name = title;
  for (int n = 2; std::ranges::count(choices, name, &FigureChoice::name) > 0; ++n) {
    name = fmt::format("{} ({})", title, n);
  }
  return name;
}

void add_to_group(const ComparedTest& test, const ComparedCurve& curve,
                  std::vector<CurveGroup>& groups) {
  const std::vector<std::size_t> order = drawn_order(curve);
  if (order.empty()) return;
  auto group = std::ranges::find_if(
      groups, [&](const CurveGroup& other) { return is_of_group(other, curve); });
  const bool is_first = group == groups.end();
  if (is_first) group = groups.insert(groups.end(), CurveGroup{&curve, {.choose = "Test"}});
  Figure panel = curve_layers(test, curve, order);
  FigureAxis& axis = group->figure.figure.x;
  axis.log = panel.x.log && (is_first || axis.log);
  std::vector<FigureChoice>& choices = group->figure.choices;
  choices.push_back({choice_name(panel.title, choices), std::move(panel.layers)});
}

/// The figure of a group, without choices where it has one test.
ReportFigure finished(CurveGroup group) {
  ReportFigure figure = std::move(group.figure);
  const std::string name = axis_words(group.first->quantity);
  figure.figure.title = fmt::format("Measured and predicted {}", name);
  if (figure.choices.size() == 1) {
    figure.figure.layers = std::move(figure.choices.front().layers);
    figure.choices.clear();
    figure.choose.clear();
  }
  show_quantity(*group.first, figure);
  return figure;
}

/// Loop of a record, of which at most kMostSamples samples are drawn.
Figure loop_panel(const ComparedTest& test) {
  constexpr std::size_t kMostSamples = 4000;
  LineLayer measured{.legend = "measured", .stroke = {.colour = kBlack, .width = 1.2}};
  LineLayer predicted{.legend = "predicted", .stroke = {.colour = kBlue, .width = 1.2}};
  const std::size_t step = test.loop.displacement.size() / kMostSamples + 1;
  for (std::size_t i = 0; i < test.loop.displacement.size(); i += step) {
    if (!std::isfinite(test.loop.predicted[i])) continue;
    for (LineLayer* layer : {&measured, &predicted}) layer->x.push_back(test.loop.displacement[i]);
    measured.y.push_back(test.loop.measured[i]);
    predicted.y.push_back(test.loop.predicted[i]);
  }
  Figure panel{.title = title_of(test), .layers = {std::move(measured), std::move(predicted)}};
  show_x(panel, "displacement", "m");
  show_y(panel, "force", "N");
  return panel;
}

/// Some of the tests, spread over all.
std::vector<const ComparedTest*> shown_tests(std::span<const ComparedTest> tests) {
  std::vector<const ComparedTest*> shown;
  const std::size_t count = std::min(tests.size(), kMostComparedTests);
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back(&tests[count == 1 ? 0 : i * (tests.size() - 1) / (count - 1)]);
  }
  return shown;
}

std::vector<Figure> panels_of(const ComparedTest& test) {
  std::vector<Figure> panels;
  if (!test.loop.displacement.empty()) panels.push_back(loop_panel(test));
  for (const ComparedCurve& curve : test.curves) {
    if (curve.part != TestPart::kCurve) continue;
    const std::vector<std::size_t> order = drawn_order(curve);
    if (!order.empty()) panels.push_back(curve_panel(test, curve, order));
  }
  return panels;
}

}  // namespace

std::vector<ReportFigure> comparison_figures(std::span<const ComparedTest> tests) {
  std::vector<CurveGroup> groups;
  for (const ComparedTest& test : tests) {
    for (const ComparedCurve& curve : test.curves) {
      if (curve.part == TestPart::kCurve) add_to_group(test, curve, groups);
    }
  }
  std::vector<ReportFigure> figures;
  for (CurveGroup& group : groups) figures.push_back(finished(std::move(group)));
  return figures;
}

FigureGrid comparison_figure(std::span<const ComparedTest> tests) {
  FigureGrid grid{.title = "", .columns = 0, .panels = {}};
  bool even = true;  // all tests have as many panels
  for (const ComparedTest* test : shown_tests(tests)) {
    std::vector<Figure> panels = panels_of(*test);
    even = even && (grid.columns == 0 || panels.size() == grid.columns);
    grid.columns = panels.size();
    std::ranges::move(panels, std::back_inserter(grid.panels));
  }
  if (!even || grid.columns == 0) grid.columns = 2;
  if (grid.panels.empty()) {
    throw InputError("compared tests", 0, "must have a value that is measured and predicted");
  }
  return grid;
}

PictureSize comparison_size(const FigureGrid& figure) {
  constexpr int kColumn = 500;
  constexpr int kRow = 380;
  const auto rows = static_cast<int>((figure.panels.size() + figure.columns - 1) / figure.columns);
  return {kColumn * static_cast<int>(figure.columns), 40 + kRow * rows};
}

}  // namespace microslip
