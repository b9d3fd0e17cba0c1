// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>

#include "microslip/report/prediction_figures.hpp"
#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

constexpr const char* kBandHolds =
    " Between the edges lies most of the draws at each point by itself: neither edge as a whole is "
    "a "
    "prediction, and peaks have a spread of their own, in the comments of the table.";

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

}  // namespace

ReportSection curves_section(const ExperimentResults& results) {
  ReportSection section{.title = "Curves", .blocks = {}};
  const PredictedCurves& curves = results.curves;
  if (!curves.any()) return section;
  section.blocks.emplace_back(ReportText{
      "Predictions by models, from tables in this folder. The calls that made them, with "
      "model and draws, stand in the last section."});
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
  return section;
}

}  // namespace microslip
