// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "microslip/report/record_figures.hpp"
#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

/// The largest harmonic of the force at each level. [AR14 Fig. 7]
ReportFigure control_figure(const std::vector<ForceControlLevel>& levels) {
  ReportTrace before{
      .name = "before control", .kind = TraceKind::kPoints, .stroke = {.colour = kPurple}};
  ReportTrace after{
      .name = "after control", .kind = TraceKind::kPoints, .stroke = {.colour = kBlue}};
  for (const ForceControlLevel& level : levels) {
    if (level.before.empty()) continue;
    before.x.push_back(level.response);
    before.y.push_back(std::ranges::max(level.before) / kPercent);
    after.y.push_back(std::ranges::max(level.after) / kPercent);
  }
  after.x = before.x;
  const auto [lowest, highest] = std::ranges::minmax(before.x);
  return {.title = "Force control over the levels",
          .caption =
              "The largest harmonic of the force from the second, in percent of the first. "
              "[AR14 Fig. 7]",
          .x = {.label = "response at the exciter", .unit = "m/s²", .log_switch = true},
          .y = {.label = "largest harmonic", .unit = "%", .log = true, .log_switch = true},
          .choices = {{"", {before, after, one_percent(lowest, highest)}}}};
}

ReportFigure control_harmonics_figure(const std::vector<ForceControlLevel>& levels) {
  ReportFigure figure{
      .title = "Harmonics of the force",
      .caption = "At one level, in percent of the first.",
      .x = {.label = "harmonic", .unit = "1"},
      .y = {.label = "share of the first", .unit = "%", .log = true, .log_switch = true},
      .choose = "Level"};
  for (const ForceControlLevel& level : levels) {
    ReportTrace before{
        .name = "before control", .kind = TraceKind::kBars, .stroke = {.colour = kPurple}};
    ReportTrace after{
        .name = "after control", .kind = TraceKind::kBars, .stroke = {.colour = kBlue}};
    for (std::size_t i = 0; i < level.before.size(); ++i) {
      before.x.push_back(static_cast<double>(i + 2));
      before.y.push_back(level.before[i] / kPercent);
      after.y.push_back(level.after[i] / kPercent);
    }
    after.x = before.x;
    if (before.x.empty()) continue;
    const ReportTrace limit = one_percent(1.4, before.x.back() + 0.6);
    figure.choices.push_back({level.level, {before, after, limit}});
  }
  figure.x.range = harmonics_range(figure.choices);
  figure.chosen = figure.choices.empty() ? 0 : figure.choices.size() - 1;
  return figure;
}

ReportFigure distortion_figure(const ExperimentResults& results) {
  ReportFigure figure{
      .title = "Distortion of the force",
      .caption = "All harmonics of the force from the second over the first, at each level.",
      .x = amplitude_axis(),
      .y = {.label = "distortion", .unit = "%", .log_switch = true},
      .choices = {{"",
                   {at_levels(results, "force", in_unit(results.levels->force_distortion, kPercent),
                              {}, kBlue)}}}};
  return figure;
}

/// Only a test whose truth is there can be made again with another force.
bool is_virtual(const ExperimentResults& results) {
  return results.truth.has_value() || results.true_levels.has_value();
}

std::string text_of(const ExperimentResults& results) {
  std::string text =
      "Two cycles of a record, and the harmonics of the Fourier series that was fitted to the "
      "whole "
      "of it.";
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
    section.blocks.emplace_back(control_figure(results.force_control));
    section.blocks.emplace_back(control_harmonics_figure(results.force_control));
  } else if (results.levels || !results.records.empty()) {
    if (is_virtual(results)) {
      section.blocks.emplace_back(ReportMissing{
          "No force before the harmonics of the drive were corrected: no force_control.csv in this "
          "folder.",
          "microslip measure rig.toml --out DIR --before-control"});
    }
    if (results.levels && !results.levels->force_distortion.empty()) {
      section.blocks.emplace_back(distortion_figure(results));
    }
  }
  return section;
}

}  // namespace microslip
