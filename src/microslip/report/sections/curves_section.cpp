// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/report/figures/prediction_figures.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

constexpr const char* kBandHolds =
    " The band is pointwise: neither edge as a whole is a prediction, and the comments of the "
    "table give the spread of peaks.";

bool has_band(const Figure& figure) {
  for (const Layer& layer : figure.layers) {
    if (std::holds_alternative<BandLayer>(layer)) return true;
  }
  return false;
}

/// Each panel a figure. @param caption  of the first
void add_panels(ReportSection& section, FigureGrid grid, const std::string& title,
                const std::string& caption) {
  bool first = true;
  for (Figure& panel : grid.panels) {
    panel.title = title;
    panel.caption = first ? caption : "";
    if (has_band(panel)) panel.caption += kBandHolds;
    if (!first) panel.title = title + ": " + panel.y.label;
    section.blocks.emplace_back(ReportFigure{.figure = std::move(panel)});
    first = false;
  }
}

/// Numbers as a table, curves as figures.
void add_ensemble(ReportSection& section, const std::vector<EnsembleCurve>& curves) {
  ReportTable table{
      .title = "Ensemble",
      .caption = "From ensemble.csv: medians of all jobs, and the range of most of them.",
      .columns = {{"jobs of"},
                  {"quantity"},
                  {"at"},
                  {"median"},
                  {"lower"},
                  {"upper"},
                  {"unit"},
                  {"jobs", "", 0}}};
  const auto text = [](double value) {
    return std::isnan(value) ? std::string() : fmt::format("{:.5g}", value);
  };
  for (const EnsembleCurve& curve : curves) {
    if (is_curve(curve)) continue;
    for (std::size_t i = 0; i < curve.at.size(); ++i) {
      table.rows.push_back({curve.group, curve.output,
                            curve.axis.empty() ? "" : text(curve.at[i]) + " " + curve.axis_unit,
                            text(curve.median[i]), text(curve.band.lower[i]),
                            text(curve.band.upper[i]), curve.unit, curve.count[i]});
    }
  }
  if (!table.rows.empty()) section.blocks.emplace_back(std::move(table));
  if (std::ranges::none_of(curves, is_curve)) return;
  FigureGrid grid = ensemble_figure(curves);
  for (Figure& panel : grid.panels) {
    panel.title = panel.title.empty() ? panel.y.label : panel.title + ": " + panel.y.label;
    panel.caption = "From ensemble.csv.";
    panel.caption += kBandHolds;
    section.blocks.emplace_back(ReportFigure{.figure = std::move(panel)});
  }
}

}  // namespace

ReportSection curves_section(const ExperimentResults& results) {
  ReportSection section{.title = "Curves", .blocks = {}};
  const PredictedCurves& curves = results.curves;
  if (!curves.any()) return section;
  section.blocks.emplace_back(ReportText{
      "Predictions by models, from tables in this folder. The commands that made them, with "
      "model and draws, are listed in the last section."});
  if (curves.response) {
    add_panels(section, response_figure(*curves.response), "Frequency response", "From frf.csv.");
  }
  if (curves.backbone) {
    add_panels(section, backbone_figure(*curves.backbone), "Backbone", "From backbone.csv.");
  }
  if (curves.joint) {
    add_panels(section, joint_figures(*curves.joint), "Joint over the amplitude",
               "From curve.csv.");
  }
  if (!curves.march.empty()) {
    add_panels(section, histories_figure(curves.march), "March", "From march.csv.");
  }
  if (!curves.ensemble.empty()) add_ensemble(section, curves.ensemble);
  return section;
}

}  // namespace microslip
