// SPDX-License-Identifier: MIT
#include "microslip/report/sections/record_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/compared_loops.hpp"
#include "microslip/report/figures/force_layers.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/report/figures/shown_samples.hpp"
#include "microslip/workflow/text/departure_meanings.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostOfAll = 24000;  // samples of all records: some 2 MB of a page
constexpr std::size_t kMostOfOne = 6000;

std::size_t most_samples(const ExperimentResults& results) {
  return std::min(kMostOfOne, kMostOfAll / results.force_paths.size());
}

/// "2: random.csv"
std::string choice_name(const ForcePath& path) {
  return fmt::format("{}: {}", path.record + 1, path.source);
}

/// A figure of which the reader chooses the record. @param make  its layers.
template <class Make>
ReportFigure of_records(const ExperimentResults& results, Figure figure, const Make& make) {
  ReportFigure shown{.figure = std::move(figure), .choose = "Record"};
  for (const ForcePath& path : results.force_paths) {
    std::vector<Layer> layers = make(path);
    if (!layers.empty()) shown.choices.push_back({choice_name(path), std::move(layers)});
  }
  return shown;
}

/// Text on the parts of the records that are not drawn, and the reason.
std::string not_drawn_text(const ExperimentResults& results) {
  const std::size_t most = most_samples(results);
  std::string text;
  const auto is_long = [most](const ForcePath& path) { return path.time.size() > most; };
  if (std::ranges::any_of(results.force_paths, is_long)) {
    text = fmt::format(
        "Of a record of more than {} samples the highest and lowest of each interval of time are "
        "drawn; numbers are of all samples. ",
        most);
  }
  const auto has_gaps = [](const ForcePath& path) {
    return std::ranges::any_of(path.found, [](double force) { return std::isnan(force); });
  };
  if (std::ranges::any_of(results.force_paths, has_gaps)) {
    text +=
        "The line of the joint has gaps where its state is unknown: it had slipped before, and "
        "moves beyond the recorded range. ";
  }
  if (!text.empty()) text.pop_back();
  return text;
}

std::string parts_text(const ExperimentResults& results) {
  std::string text;
  for (const ForcePath& path : results.force_paths) {
    const RecordPart part = part_for_loops(path, most_samples(results));
    if (part.begin == 0 && part.end == path.time.size()) continue;
    text += fmt::format(" Of {} the part from {:.4g} to {:.4g} s, about the largest displacement.",
                        path.source, path.time[part.begin], path.time[part.end - 1]);
  }
  return text;
}

/// The message of a section in which nothing can be drawn.
ReportMissing nothing_drawn() {
  return {
      "No forces and no loops: none of the recordings that the joint was identified from is in "
      "this folder.",
      ""};
}

std::string state_of(const RecordFound& record) {
  return record.start_from.empty() ? record.start
                                   : fmt::format("{}, {}", record.start, record.start_from);
}

/// The one offset, or how far several reach.
std::string offset_text(const std::vector<double>& offset) {
  if (offset.empty()) return "";
  const auto [low, high] = std::ranges::minmax(offset);
  return offset.size() == 1 ? fmt::format("{:.3g}", low)
                            : fmt::format("{:.3g} to {:.3g}", low, high);
}

const ForcePath* path_of(const ExperimentResults& results, std::size_t record) {
  const auto found = std::ranges::find(results.force_paths, record, &ForcePath::record);
  return found == results.force_paths.end() ? nullptr : &*found;
}

ReportTable record_table(const ExperimentResults& results) {
  ReportTable table{
      .title = "Records",
      .caption =
          "Scatter is that of one sample, including what the joint leaves unexplained; "
          "correlation that of neighbouring residuals. The initial state is detected from the "
          "first samples, given by an option or assumed.",
      .columns = {{.name = "record", .unit = "1", .digits = 0},
                  {.name = "file"},
                  {.name = "samples", .unit = "1", .digits = 0},
                  {.name = "start"},
                  {.name = "unexplained", .unit = "%", .digits = 3},
                  {.name = "scatter of the force", .unit = "N", .digits = 3},
                  {.name = "correlation", .unit = "1", .digits = 2},
                  {.name = "offset", .unit = "N"},
                  {.name = "noise of the displacement", .unit = "µm", .digits = 3}}};
  const std::vector<RecordFound>& records = results.joint->by_records->records;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const RecordFound& record = records[r];
    const ForcePath* path = path_of(results, r);
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    table.rows.push_back({static_cast<double>(r + 1), std::string(file_name(record.source)),
                          path ? static_cast<double>(path->time.size()) : nothing, state_of(record),
                          record.unexplained / kPercent, record.scatter, record.correlation,
                          offset_text(record.offset),
                          path ? path->displacement_noise / kMicrometre : nothing});
  }
  return table;
}

/// Each departure in each record, shares of the force beside those of noise.
ReportTable table_of_all_verdicts(const std::vector<RecordFound>& records) {
  ReportTable table{.title = "Tested assumptions, record by record",
                    .columns = {{.name = "record", .unit = "1", .digits = 0},
                                {.name = "departure"},
                                {.name = "of the force", .unit = "%", .digits = 2},
                                {.name = "by noise", .unit = "%", .digits = 2},
                                {.name = "found"}}};
  for (std::size_t r = 0; r < records.size(); ++r) {
    for (const DepartureFound& one : records[r].verdicts) {
      if (one.broken) table.marked.push_back(table.rows.size());
      table.rows.push_back({static_cast<double>(r + 1), departure_with_code(one.departure),
                            one.share / kPercent, one.noise / kPercent, one.broken ? "yes" : "no"});
    }
  }
  return table;
}

}  // namespace

ReportSection record_force_section(const ExperimentResults& results) {
  ReportSection section{.title = "Force along the record", .blocks = {}};
  if (results.force_paths.empty()) {
    section.blocks.emplace_back(nothing_drawn());
    return section;
  }
  const std::size_t most = most_samples(results);
  if (results.force_paths.size() < results.joint->by_records->records.size()) {
    section.blocks.emplace_back(ReportText{
        fmt::format("{} of the {} records are drawn; microslip report --records draws more.",
                    results.force_paths.size(), results.joint->by_records->records.size())});
  }
  ReportFigure force =
      of_records(results, {.title = "Force over time", .caption = not_drawn_text(results)},
                 [most](const ForcePath& path) { return force_layers(path, most); });
  show_x(force, "time", "s");
  show_y(force, kLoopForce, "N");
  ReportFigure residual = of_records(
      results,
      {.title = "Residual over time",
       .caption = "Measured less found force. Noise is even; waves and trends are what the joint "
                  "does not explain."},
      [&](const ForcePath& path) {
        return residual_layers(path, scatter_of(results, path), most);
      });
  show_x(residual, "time", "s");
  show_y(residual, kResidualLabel, "N");
  for (ReportFigure* figure : {&force, &residual}) {
    figure->chart = ChartKind::kTimeHistory;
    figure->wide = true;
    if (!figure->choices.empty()) section.blocks.emplace_back(std::move(*figure));
  }
  return section;
}

ReportSection record_loops_section(const ExperimentResults& results) {
  ReportSection section{.title = "Measured loops", .blocks = {}};
  if (results.force_paths.empty()) return section;
  const std::size_t most = most_samples(results);
  ReportFigure loops = of_records(
      results,
      {.title = "Measured and found loops",
       .caption = "The force of the joint with the offset of the record." + parts_text(results)},
      [most](const ForcePath& path) { return loop_layers(path, most); });
  show_x(loops, kLoopDisplacement, "m");
  show_y(loops, kLoopForce, "N");
  ReportFigure residual = of_records(
      results,
      {.title = "Residual over displacement",
       .caption = "Means of all samples at which the displacement rises, and at which it falls: "
                  "the right joint leaves both at zero."},
      [&](const ForcePath& path) {
        return residual_over_displacement(path, scatter_of(results, path));
      });
  show_x(residual, kLoopDisplacement, "m");
  show_y(residual, kResidualLabel, "N");
  for (ReportFigure* figure : {&loops, &residual}) {
    if (!figure->choices.empty()) section.blocks.emplace_back(std::move(*figure));
  }
  return section;
}

ReportSection derived_section(const ExperimentResults& results) {
  ReportSection section{.title = "Dissipation and stiffness", .blocks = {}};
  if (!(results.joint->joint.density().largest_slip_force() > 0.0)) return section;
  section.blocks.emplace_back(ReportText{
      fmt::format("The joint in steady vibration, up to the largest half range of the records: "
                  "computed from its density, not measured{}.",
                  results.joint->by_records->viscous ? ", and without the viscous part" : "")});
  for (Figure& figure : joint_figures(results).panels) {
    figure.legend = Legend::kBelow;
    section.blocks.emplace_back(ReportFigure{.figure = std::move(figure)});
  }
  return section;
}

ReportSection records_section(const ExperimentResults& results) {
  ReportSection section{.title = "Records", .blocks = {}};
  section.blocks.emplace_back(record_table(results));
  const std::vector<RecordFound>& records = results.joint->by_records->records;
  if (records.size() > 1) section.blocks.emplace_back(table_of_all_verdicts(records));
  return section;
}

}  // namespace microslip
