// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/record_figures.hpp"
#include "microslip/report/figures/rig_figures.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

constexpr double kMilliradian = 1e-3;

std::vector<std::string> channels_of(const std::vector<ChannelMisfit>& comparisons) {
  std::vector<std::string> names;
  for (const ChannelMisfit& row : comparisons) {
    if (std::ranges::find(names, row.channel) == names.end()) names.push_back(row.channel);
  }
  return names;
}

/// Status and flags of a row of the table.
std::string remarks_of(const ChannelMisfit& row) {
  std::string text = row.status == "converged" ? "" : row.status;
  if (!row.flags.empty()) text += (text.empty() ? "" : " ") + row.flags;
  return text;
}

/// Table with one row per record and the NRMSE of its channels. The comparisons of a record follow
/// each other.
ReportTable misfit_table(const std::vector<ChannelMisfit>& comparisons) {
  const std::vector<std::string> channels = channels_of(comparisons);
  ReportTable table{.title = "Predicted against recorded",
                    .caption =
                        "NRMSE of each channel: rms of the difference over rms of the record. The "
                        "first harmonic at the exciter is given to the model and fits with any "
                        "joint; the force shows the joint.",
                    .columns = {{"record"}, {"frequency", "Hz", 5}, {"response", "m/s²"}}};
  for (const std::string& channel : channels) table.columns.push_back({channel, "%", 3});
  const bool remarks = std::ranges::any_of(
      comparisons, [](const ChannelMisfit& row) { return !remarks_of(row).empty(); });
  if (remarks) table.columns.push_back({"remarks"});
  std::string source;
  for (const ChannelMisfit& row : comparisons) {
    if (table.rows.empty() || row.source != source) {
      source = row.source;
      table.rows.push_back({source, row.frequency, row.response_amplitude});
      table.rows.back().resize(table.columns.size(), std::numeric_limits<double>::quiet_NaN());
      if (remarks) table.rows.back().back() = remarks_of(row);
      if (!remarks_of(row).empty()) table.marked.push_back(table.rows.size() - 1);
    }
    const auto channel = std::ranges::find(channels, row.channel) - channels.begin();
    table.rows.back()[3 + static_cast<std::size_t>(channel)] = row.nrmse / kPercent;
  }
  return table;
}

/// NRMSE and noise, a choice per channel.
ReportFigure misfit_figure(const ExperimentResults& results) {
  ReportFigure figure{.choose = "Channel", .wide = true};
  for (Figure& channel : deviation_figures(results)) {
    figure.choices.push_back({channel.title, std::move(channel.layers)});
    figure.figure = std::move(channel);
  }
  figure.figure.title = "Misfit of the prediction";
  figure.figure.caption =
      "NRMSE of a channel, and of its noise alone: the residual of the best Fourier series. "
      "At points on their noise the error of the model is below noise.";
  figure.figure.layers.clear();
  return figure;
}

/// A value of each channel over the response.
ReportFigure over_response(const std::vector<ChannelMisfit>& comparisons, std::string title,
                           std::string caption, const ShownUnit& unit,
                           double (*value)(const ChannelMisfit&)) {
  Figure figure{.title = std::move(title), .caption = std::move(caption)};
  int colour = kBlue;
  for (const std::string& channel : channels_of(comparisons)) {
    PointLayer points{.legend = channel, .colour = colour++};
    for (const ChannelMisfit& row : comparisons) {
      if (row.channel != channel) continue;
      points.x.push_back(row.response_amplitude);
      points.y.push_back(value(row) / unit.size);
    }
    figure.layers.emplace_back(std::move(points));
  }
  show_response(figure, {}, false);
  figure.y = {.label = "error of the first harmonic", .unit = unit.text};
  return {.figure = std::move(figure)};
}

ReportFigure amplitude_figure(const std::vector<ChannelMisfit>& comparisons) {
  return over_response(comparisons, "Amplitude error",
                       "First harmonic predicted over recorded, less 1.", {"%", kPercent},
                       [](const ChannelMisfit& row) { return row.amplitude_ratio - 1.0; });
}

ReportFigure phase_figure(const std::vector<ChannelMisfit>& comparisons) {
  return over_response(comparisons, "Phase error", "First harmonic, predicted less recorded.",
                       {"mrad", kMilliradian},
                       [](const ChannelMisfit& row) { return row.phase_error; });
}

}  // namespace

ReportSection predictions_section(const ExperimentResults& results) {
  ReportSection section{.title = "Prediction", .blocks = {}};
  if (results.comparisons.empty() && results.predictions.empty()) {
    if (results.comparison) return section;  // which has a section of its own
    section.blocks.emplace_back(
        ReportMissing{"No prediction compared with recordings: no verification.csv in this folder.",
                      "microslip verify rig.toml joint.json recordings/level_* --out "
                      "verification.csv --histories "
                      "verification_histories.csv"});
    return section;
  }
  section.blocks.emplace_back(
      ReportText{results.predictions_are_of_this_joint
                     ? "Predictions of the identified joint for the rig at the recorded frequency "
                       "and response, against the record. [AR14 Fig. 11]"
                     : "Predictions of another joint or rig than those of this report, at the "
                       "recorded frequency and response, against the record: run verify again."});
  add_records(section, results, results.predictions, kPredictedNames);
  if (!results.comparisons.empty()) {
    section.blocks.emplace_back(misfit_figure(results));
    section.blocks.emplace_back(amplitude_figure(results.comparisons));
    section.blocks.emplace_back(phase_figure(results.comparisons));
    section.blocks.emplace_back(misfit_table(results.comparisons));
  }
  return section;
}

}  // namespace microslip
