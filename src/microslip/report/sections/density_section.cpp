// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "microslip/joint/dissipation.hpp"
#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/sections/sections.hpp"
#include "microslip/workflow/results/other_methods.hpp"

namespace microslip {
namespace {

constexpr Stroke kSpline = {.colour = kGreen, .width = 1.4};
constexpr const char* kSplineName = "smoothing spline";

/// Densities by other methods from the same levels.
FigureOptions method_options(const MethodComparison& methods, const std::string& used) {
  FigureOptions options;
  if (used != "inversion") options.others.push_back({"inversion", methods.inversion.joint});
  const SignedDensity& spline = methods.spline.density;
  const SignedDensity& differences = methods.differences;
  options.beside = {LineLayer{spline.slip_force, spline.density, kSplineName, kSpline},
                    PointLayer{.x = differences.slip_force,
                               .y = differences.density,
                               .legend = "differences",
                               .colour = kGrey,
                               .shown = false}};
  return options;
}

Figure density_with_methods(const ExperimentResults& results,
                            const std::optional<MethodComparison>& methods) {
  if (!methods) return density_figure(results);
  Figure figure = density_figure(results, method_options(*methods, results.joint->found_by()));
  // A joint of atoms alone has no density beside which the others would be drawn.
  if (std::ranges::find(figure.layers, kSplineName, legend_of) == figure.layers.end())
    return figure;
  figure.caption +=
      " A natural spline ends at 0 whatever the joint does. Unsmoothed differences are hidden at "
      "first.";
  return figure;
}

/// Adds slopes of D between neighbouring levels, and of its smoothing spline.
void add_measured_slopes(Figure& figure, const MethodComparison& methods) {
  const MeasuredSlopes slopes = measured_slopes(methods);
  figure.layers.emplace_back(PointLayer{.x = slopes.differences.x,
                                        .y = slopes.differences.y,
                                        .legend = "differences",
                                        .colour = kGrey});
  figure.layers.emplace_back(LineLayer{slopes.spline.x, slopes.spline.y, kSplineName, kSpline});
}

std::string slope_caption(const ExperimentResults& results) {
  std::string text =
      "D′ = 4Φ1(kA) tends to four times the macro-slip force; its own slope over 4k²A is the "
      "density.";
  if (!results.joint->band_slip_force.empty()) {
    text +=
        " It has no band: that of the density is pointwise, and D′ is an integral over slip "
        "forces.";
  }
  if (results.joint->linear_damping) text += " D is corrected for the linear damping βA².";
  return text;
}

/// D′ = 4Φ1(kA). [AR14 (8)]
Figure slope_figure(const ExperimentResults& results,
                    const std::optional<MethodComparison>& methods) {
  Figure figure{.title = "Slope of the dissipation", .caption = slope_caption(results)};
  if (methods) add_measured_slopes(figure, *methods);
  add_curves(figure, results, {}, dissipation_slope);
  show_amplitude(figure, {}, false);
  show_y(figure, "D′", "N");
  figure.y.log_switch = true;
  return figure;
}

/// The score that chose λ.
Figure smoothing_path_figure(const InversionResult& result) {
  LineLayer score{.legend = "score"};
  for (const PathPoint& point : result.path) {
    if (!std::isfinite(point.gcv)) continue;
    score.x.push_back(point.edf);
    score.y.push_back(point.gcv);
  }
  const PathPoint& chosen = result.path[result.chosen];
  PointLayer mark{.x = {chosen.edf},
                  .y = {chosen.gcv},
                  .legend = fmt::format("chosen: λ = {:.3g}, {:.1f} degrees of freedom",
                                        chosen.lambda, chosen.edf),
                  .colour = kVermillion};
  return {.title = "Path of the smoothing parameter",
          .caption =
              "Cross-validation score of the inversion from stiff (left) to flexible; a flat "
              "valley leaves the choice open. The automatic choice is the least that the "
              "likelihood of the levels also allows.",
          .x = {.label = "effective degrees of freedom", .unit = "1"},
          .y = {.label = "cross-validation score", .unit = "1", .log = true, .log_switch = true},
          .layers = {std::move(score), std::move(mark)}};
}

/// The density along that path.
Figure smoothings_figure(const MethodComparison& methods) {
  const double to = methods.inversion.covered_to;
  const double from = 0.9 * methods.inversion.covered_from;
  Figure figure{.title = "Density along the path",
                .caption =
                    "The inversion with other λ than the chosen one: what stays the same is "
                    "determined by the data, the rest by the smoothing.",
                .x = {.range = AxisRange{0.0, 1.04 * to}}};
  int colour = kVermillion;
  double top = 0.0;
  for (const auto& [factor, found] : varied_inversions(methods)) {
    const bool chosen = factor == 1.0;
    DensityPoints points = density_points(found.joint, from, to);
    for (const double value : points.density) top = std::max(top, value);
    figure.layers.emplace_back(LineLayer{
        std::move(points.slip_force), std::move(points.density),
        fmt::format("{}, {:.1f} degrees of freedom",
                    chosen ? "chosen λ" : fmt::format("{:g} λ", factor), found.inversion()->edf),
        chosen ? kFound : Stroke{.colour = colour, .width = 1.2}});
    if (!chosen) ++colour;
  }
  if (top > 0.0) figure.y.range = AxisRange{0.0, 1.08 * top};
  show_x(figure, "slip force f*", "N");
  show_y(figure, "density φ", "1/N");
  figure.x.log_switch = figure.y.log_switch = true;
  return figure;
}

}  // namespace

ReportSection density_section(const ExperimentResults& results,
                              const std::optional<MethodComparison>& methods) {
  ReportSection section{.title = "Density", .blocks = {}};
  if (!results.joint) {
    section.blocks.emplace_back(
        ReportMissing{"No density and no loops: no joint.json in this folder.",
                      "microslip identify levels.csv --stiffness K --bands 1000 "
                      "--out joint.json --density-csv density.csv"});
    return section;
  }
  if (!(results.joint->joint.density().largest_slip_force() > 0.0)) {
    section.blocks.emplace_back(ReportMissing{"No density: no part of the joint slips."});
    return section;
  }
  const auto add = [&](Figure figure, bool wide = false) {
    section.blocks.emplace_back(ReportFigure{.figure = std::move(figure), .wide = wide});
  };
  add(density_with_methods(results, methods), true);
  if (results.levels) add(slope_figure(results, methods));
  if (methods) {
    add(smoothing_path_figure(*methods->inversion.inversion()));
    add(smoothings_figure(*methods));
  }
  return section;
}

}  // namespace microslip
