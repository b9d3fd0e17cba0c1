// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/record_figures.hpp"
#include "microslip/report/figures/rig_figures.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

ReportFigure control_harmonics_figure(const std::vector<ForceControlLevel>& levels) {
  ReportFigure figure{.choose = "Level"};
  for (const ForceControlLevel& level : levels) {
    if (level.before.empty()) continue;
    figure.figure = force_harmonics_figure(level);
    figure.choices.push_back({level.level, std::move(figure.figure.layers)});
  }
  figure.chosen = figure.choices.size() - 1;
  figure.figure.layers.clear();
  return figure;
}

Figure distortion_figure(const MeasuredLevels& levels) {
  Figure figure{
      .title = "Distortion of the force",
      .caption = "All harmonics of the force from the second over the first, at each level.",
      .layers = {at_levels(levels, {levels.force_distortion, {}}, "force", kBlue)}};
  show_amplitude(figure, {}, false);
  show_y(figure, "distortion", "%");
  figure.y.log_switch = true;
  return figure;
}

/// Only a test whose truth is there can be made again with another force.
bool is_virtual(const ExperimentResults& results) {
  return results.truth.has_value() || results.true_levels.has_value();
}

std::string text_of(const ExperimentResults& results) {
  std::string text =
      "Two cycles of a record, and the harmonics of the Fourier series that was fitted to the "
      "whole of it.";
  const auto over_time = std::ranges::count_if(
      results.records, [](const LevelRecord& record) { return !record.signals.empty(); });
  if (static_cast<std::size_t>(over_time) < results.record_count) {
    text += fmt::format(
        " {} of the {} records are shown over time{}; microslip report --records "
        "shows more.",
        over_time, results.record_count,
        results.records.size() < results.record_count
            ? ", and as many by their harmonics: all would be too much for a page"
            : "");
  }
  return text;
}

}  // namespace

ReportSection signals_section(const ExperimentResults& results) {
  ReportSection section{.title = "Signals", .blocks = {}};
  if (results.records.empty()) {
    section.blocks.emplace_back(
        ReportMissing{"No time histories and harmonics: no recordings level_* in this folder or in "
                      "recordings/ of it."});
  } else {
    section.blocks.emplace_back(ReportText{text_of(results)});
    add_records(section, results, results.records, kControlNames);
  }
  const bool controlled = std::ranges::any_of(
      results.force_control, [](const ForceControlLevel& level) { return !level.before.empty(); });
  if (controlled) {
    section.blocks.emplace_back(ReportText{
        "The force before and after the harmonics of the drive were corrected, at every level."});
    section.blocks.emplace_back(
        ReportFigure{.figure = force_distortion_figure(results.force_control)});
    section.blocks.emplace_back(control_harmonics_figure(results.force_control));
  } else if (results.levels || !results.records.empty()) {
    if (is_virtual(results)) {
      section.blocks.emplace_back(ReportMissing{
          "No force before the harmonics of the drive were corrected: no force_control.csv in this "
          "folder.",
          "microslip measure rig.toml --out DIR --before-control"});
    }
    if (results.levels && !results.levels->force_distortion.empty()) {
      section.blocks.emplace_back(ReportFigure{.figure = distortion_figure(*results.levels)});
    }
  }
  return section;
}

}  // namespace microslip
