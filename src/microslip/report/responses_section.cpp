// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

ReportTrace curve(std::string name, double response, const std::vector<double>& frequency,
                  const std::vector<double>& force, Stroke stroke) {
  ReportTrace trace{.name = std::move(name), .x = frequency, .stroke = stroke};
  for (const double value : force) trace.y.push_back(response / value);
  return trace;
}

/// The levels of the test, each near the top of its curve.
ReportTrace measured_peaks(const MeasuredLevels& test) {
  ReportTrace trace{.name = "measured levels",
                    .kind = TraceKind::kPoints,
                    .x = test.frequency,
                    .stroke = {.colour = kBlack}};
  for (std::size_t i = 0; i < test.frequency.size(); ++i) {
    trace.y.push_back(test.response_amplitude[i] / test.force_amplitude[i]);
  }
  return trace;
}

/// Acceleration over force.
ReportFigure response_figure(const ExperimentResults& results) {
  ReportFigure figure{
      .title = "Frequency responses at constant response",
      .caption =
          "Predicted by the identified joint in the rig. At a constant response the structure "
          "is equivalent-linear: the peak falls in frequency, and the damping rises. [AR14 Fig. 4]",
      .x = {.label = "frequency", .unit = "Hz"},
      .y = {.label = "acceleration over force", .unit = "m/s²/N", .log = true, .log_switch = true},
      .choices = {{"", {}}},
      .wide = true};
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  const MeasuredLevels& test = *results.levels;
  if (!test.frequency.empty() && !test.force_amplitude.empty() &&
      !test.response_amplitude.empty()) {
    traces.push_back(measured_peaks(test));
  }
  int colour = kBlue;
  std::vector<ReportTrace> expected;
  for (const ConstantResponse& response : results.responses) {
    const std::string name = fmt::format("{:.3g} m/s²", response.response);
    traces.push_back(
        curve(name, response.response, response.frequency, response.force, {.colour = colour}));
    if (!response.true_frequency.empty()) {
      expected.push_back(curve(name + ", true joint", response.response, response.true_frequency,
                               response.true_force,
                               {.colour = kBlack, .style = LineStyle::kDotted, .width = 1.4}));
      expected.back().group = "true joint";
    }
    ++colour;
  }
  std::ranges::move(expected, std::back_inserter(traces));
  return figure;
}

}  // namespace

ReportSection responses_section(const ExperimentResults& results) {
  ReportSection section{.title = "Responses", .blocks = {}};
  if (results.responses.empty() || !results.levels) {
    section.blocks.emplace_back(
        ReportMissing{"No frequency responses, which need rig.toml, joint.json and a levels.csv "
                      "with response amplitudes in this folder."});
  } else {
    section.blocks.emplace_back(response_figure(results));
  }
  return section;
}

}  // namespace microslip
