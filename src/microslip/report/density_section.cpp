// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "microslip/joint/dissipation.hpp"
#include "microslip/report/sections.hpp"
#include "microslip/workflow/other_methods.hpp"

namespace microslip {
namespace {

/// φ of a joint over the slip forces up to `to`, 1/kN.
ReportTrace density_curve(std::string name, const Joint& joint, double from, double to,
                          Stroke stroke) {
  DensityPoints points = density_points(joint, from, to);
  return {.name = std::move(name),
          .x = std::move(points.slip_force),
          .y = in_unit(std::move(points.density), kPerKilonewton),
          .stroke = stroke};
}

/// The band over the slip forces that the levels cover: below, the shape is an assumption.
ReportTrace band_of(const IdentifiedJoint& found) {
  ReportTrace band{.name = fmt::format("{:.0f} % band", 100.0 * found.band_confidence),
                   .kind = TraceKind::kBand,
                   .stroke = {.colour = kBlue}};
  for (std::size_t i = 0; i < found.band_slip_force.size(); ++i) {
    if (found.band_slip_force[i] < 0.9 * found.covered_from.value_or(0.0)) continue;
    band.x.push_back(found.band_slip_force[i]);
    band.lower.push_back(found.band_lower[i] / kPerKilonewton);
    band.upper.push_back(found.band_upper[i] / kPerKilonewton);
  }
  return band;
}

void add_methods(const MethodComparison& methods, const std::string& used,
                 std::vector<ReportTrace>& traces) {
  const SignedDensity& spline = methods.spline.density;
  const SignedDensity& differences = methods.differences;
  if (used != "inversion") {
    traces.push_back(density_curve("inversion", methods.inversion.joint,
                                   methods.inversion.covered_from, methods.inversion.covered_to,
                                   {.colour = kPurple}));
  }
  traces.push_back({.name = "smoothing spline",
                    .x = spline.slip_force,
                    .y = in_unit(spline.density, kPerKilonewton),
                    .stroke = {.colour = kGreen, .width = 1.4}});
  traces.push_back({.name = "differences",
                    .kind = TraceKind::kPoints,
                    .x = differences.slip_force,
                    .y = in_unit(differences.density, kPerKilonewton),
                    .stroke = {.colour = kGrey},
                    .shown = false});
}

void add_range(const IdentifiedJoint& found, std::vector<ReportTrace>& traces) {
  const auto mark = [&](const char* name, const std::optional<double>& at) {
    if (at) traces.push_back({.name = name, .kind = TraceKind::kMarker, .x = {*at}});
  };
  mark("lowest level", found.covered_from);
  mark("highest level", found.covered_to);
  const auto& atoms = found.joint.density().atoms();
  for (std::size_t i = 0; i < atoms.weight.size() && i < kMostAtomsShown; ++i) {
    mark("atom", atoms.slip_force[i]);
  }
}

double highest(const ReportTrace& trace) {
  const std::vector<double>& values = trace.kind == TraceKind::kBand ? trace.upper : trace.y;
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  return largest;
}

ReportFigure density_figure(const ExperimentResults& results,
                            const std::optional<MethodComparison>& methods) {
  const IdentifiedJoint& found = *results.joint;
  const double to = found.covered_to.value_or(found.joint.density().largest_slip_force());
  const double from = 0.9 * found.covered_from.value_or(0.0);
  ReportFigure figure{
      .title = "Slip-force density",
      .caption =
          fmt::format("Below kA of the lowest level the levels tell two moments of φ only, above "
                      "that of the highest nothing.{} [AR14 Fig. 9]",
                      methods ? " A natural spline ends at 0 whatever the joint does. Unsmoothed "
                                "differences are hidden at first."
                              : ""),
      .x = {.label = "slip force f*", .unit = "N", .log_switch = true},
      .y = {.label = "density φ", .unit = "1/kN", .log_switch = true},
      .choices = {{"", {}}},
      .wide = true};
  if (!found.joint.density().atoms().weight.empty()) {
    figure.caption +=
        " An atom, a slip force at which a part of the stiffness slips at once, is a line without "
        "height here: the summary has its weight.";
  }
  if (!found.band_slip_force.empty()) {
    figure.caption +=
        " The band holds at each slip force by itself: its lower edge as a whole is no joint, nor "
        "is "
        "its upper edge.";
  }
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  if (!found.band_slip_force.empty()) traces.push_back(band_of(found));
  traces.push_back(density_curve(kFoundName, found.joint, from, to, kFound));
  if (methods) add_methods(*methods, found.method, traces);
  if (results.truth) traces.push_back(density_curve("truth", *results.truth, 0.0, to, kTruth));
  add_range(found, traces);
  double top = 0.0;
  for (const ReportTrace& trace : traces) {
    if (trace.name != "differences" && trace.name != "smoothing spline") {
      top = std::max(top, highest(trace));
    }
  }
  figure.x.range = AxisRange{0.0, 1.04 * to};
  if (top > 0.0) figure.y.range = AxisRange{0.0, 1.08 * top};
  return figure;
}

/// Of D between neighbouring levels, and of its smoothing spline.
void add_measured_slopes(const MethodComparison& methods, std::vector<ReportTrace>& traces) {
  const MeasuredSlopes slopes = measured_slopes(methods);
  traces.push_back({.name = "differences",
                    .kind = TraceKind::kPoints,
                    .x = in_unit(slopes.differences.x, kMicrometre),
                    .y = slopes.differences.y,
                    .stroke = {.colour = kGrey}});
  traces.push_back({.name = "smoothing spline",
                    .x = in_unit(slopes.spline.x, kMicrometre),
                    .y = slopes.spline.y,
                    .stroke = {.colour = kGreen, .width = 1.4}});
}

std::string slope_caption(const ExperimentResults& results) {
  std::string text =
      "D′ = 4Φ1(kA) tends to four times the macro-slip force; its own slope over 4k²A is the "
      "density.";
  if (!results.joint->band_slip_force.empty()) {
    text +=
        " It has no band: the one of the density holds at each slip force by itself, and D′ is an "
        "integral over them.";
  }
  if (results.joint->linear_damping) text += " The linear damping βA² is taken off D.";
  return text;
}

/// D′ = 4Φ1(kA). [AR14 (8)]
ReportFigure slope_figure(const ExperimentResults& results,
                          const std::optional<MethodComparison>& methods) {
  ReportFigure figure{.title = "Slope of the dissipation",
                      .caption = slope_caption(results),
                      .x = amplitude_axis(),
                      .y = {.label = "D′", .unit = "N", .log_switch = true},
                      .choices = {{"", {}}}};
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  if (methods) add_measured_slopes(*methods, traces);
  std::ranges::move(curves_of_joints(results, dissipation_slope), std::back_inserter(traces));
  return figure;
}

/// The score that chose λ.
ReportFigure path_figure(const InversionResult& result) {
  ReportTrace score{.name = "score", .stroke = {.colour = kBlue}};
  for (const PathPoint& point : result.path) {
    if (!std::isfinite(point.gcv)) continue;
    score.x.push_back(point.edf);
    score.y.push_back(point.gcv);
  }
  const PathPoint& chosen = result.path[result.chosen];
  ReportTrace mark{.name = fmt::format("chosen: λ = {:.3g}, {:.1f} degrees of freedom",
                                       chosen.lambda, chosen.edf),
                   .kind = TraceKind::kPoints,
                   .x = {chosen.edf},
                   .y = {chosen.gcv},
                   .stroke = {.colour = kVermillion}};
  return {.title = "Path of the smoothing parameter",
          .caption =
              "Cross-validation score of the inversion from stiff (left) to flexible; a flat "
              "valley leaves the choice open. Chosen by itself, it is the least that the "
              "likelihood of the levels also allows.",
          .x = {.label = "effective degrees of freedom", .unit = "1"},
          .y = {.label = "cross-validation score", .unit = "1", .log = true, .log_switch = true},
          .choices = {{"", {score, mark}}}};
}

/// The density along that path.
ReportFigure smoothings_figure(const MethodComparison& methods) {
  const double to = methods.inversion.covered_to;
  const double from = 0.9 * methods.inversion.covered_from;
  ReportFigure figure{
      .title = "Density along the path",
      .caption =
          "The inversion with other λ than the chosen one: what stays the same is in the data, "
          "what comes and goes is the smoothing.",
      .x = {.label = "slip force f*",
            .unit = "N",
            .log_switch = true,
            .range = AxisRange{0.0, 1.04 * to}},
      .y = {.label = "density φ", .unit = "1/kN", .log_switch = true},
      .choices = {{"", {}}}};
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  int colour = kVermillion;
  const auto add = [&](const std::string& name, const Identification& found, Stroke stroke) {
    traces.push_back(
        density_curve(fmt::format("{}, {:.1f} degrees of freedom", name, found.inversion()->edf),
                      found.joint, from, to, stroke));
  };
  for (const auto& [factor, found] : varied_inversions(methods)) {
    if (factor == 1.0) {
      add("chosen λ", found, kFound);
    } else {
      add(fmt::format("{:g} λ", factor), found, {.colour = colour++, .width = 1.2});
    }
  }
  double top = 0.0;
  for (const ReportTrace& trace : traces) top = std::max(top, highest(trace));
  if (top > 0.0) figure.y.range = AxisRange{0.0, 1.08 * top};
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
  section.blocks.emplace_back(density_figure(results, methods));
  if (results.levels) section.blocks.emplace_back(slope_figure(results, methods));
  if (methods) {
    section.blocks.emplace_back(path_figure(*methods->inversion.inversion()));
    section.blocks.emplace_back(smoothings_figure(*methods));
  }
  return section;
}

}  // namespace microslip
