// SPDX-License-Identifier: MIT
#include "microslip/report/sections/calibration_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "microslip/report/figures/calibration_figures.hpp"
#include "microslip/report/figures/calibration_layers.hpp"

namespace microslip {
namespace {

constexpr const char* kWriteAgain = "microslip calibrate MODEL.toml MODAL_LEVELS.csv --out DIR";

void add_figure(ReportSection& section, Figure figure) {
  section.blocks.emplace_back(ReportFigure{.figure = std::move(figure)});
}

/// Root mean square of a column over the levels of a mode; NaN where there is none.
double rms_of(const std::vector<double>& values, const RowsOfMode& mode) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const std::size_t row : mode.rows) sum += values[row] * values[row];
  return std::sqrt(sum / static_cast<double>(mode.rows.size()));
}

/// @param mode  from 1.
double offset_of(const ExperimentResults& results, std::size_t mode) {
  if (results.calibration) {
    const auto& offsets = results.calibration->offsets;
    const auto found = std::ranges::find(offsets, mode - 1, &ModeOffset::mode);
    if (found != offsets.end()) return found->offset;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

ReportTable modes_table(const ExperimentResults& results) {
  const LevelsOfModes& levels = *results.modal_levels;
  ReportTable table{
      .title = "Modes",
      .caption =
          "Residuals are rms, over the scatter found for all modes together: 1 is typical. "
          "Offset: measured frequencies over those of the model with the joints found, less 1.",
      .columns = {{.name = "mode", .unit = "1", .digits = 0},
                  {.name = "levels", .unit = "1", .digits = 0},
                  {.name = "from", .unit = "µm", .digits = 3},
                  {.name = "to", .unit = "µm", .digits = 3},
                  {.name = "residual of losses", .unit = "1", .digits = 2},
                  {.name = "residual of frequencies", .unit = "1", .digits = 2},
                  {.name = "offset", .unit = "%", .digits = 2}}};
  for (const RowsOfMode& mode : rows_by_mode(levels)) {
    table.rows.push_back({static_cast<double>(mode.mode), static_cast<double>(mode.rows.size()),
                          levels.displacement[mode.rows.front()] / kMicrometre,
                          levels.displacement[mode.rows.back()] / kMicrometre,
                          rms_of(levels.residual, mode), rms_of(levels.frequency_residual, mode),
                          offset_of(results, mode.mode) / kPercent});
  }
  return table;
}

std::string verdict_of(const PairSummary& pair) {
  return pair.known_only_together ? "known only together" : "distinguished";
}

ReportTable pairs_table(const CalibrationSummary& found) {
  ReportTable table{
      .title = "Joint against joint",
      .caption =
          "Of the losses of both joints at a level, over the posterior; median of the levels. "
          "A correlation of −1: the more one loses, the less the other.",
      .columns = {{.name = "joint"},
                  {.name = "and"},
                  {.name = "correlation", .unit = "1", .digits = 2},
                  {.name = "sum known to", .unit = "%", .digits = 2},
                  {.name = "better one known to", .unit = "%", .digits = 2},
                  {.name = "verdict"}}};
  for (const PairSummary& pair : found.pairs) {
    if (pair.known_only_together) table.marked.push_back(table.rows.size());
    table.rows.push_back({pair.first, pair.second, pair.correlation,
                          pair.spread_together / kPercent, pair.spread_alone / kPercent,
                          verdict_of(pair)});
  }
  return table;
}

/// Range of slip forces in which the levels determine a density.
std::string determined_range_text(const DensityFound& joint) {
  double from = std::numeric_limits<double>::infinity();
  double to = 0.0;
  for (std::size_t i = 0; i < joint.variance_reduction.size(); ++i) {
    if (joint.variance_reduction[i] < kDetermined) continue;
    from = std::min(from, joint.slip_force[i]);
    to = std::max(to, joint.slip_force[i]);
  }
  if (!(to > 0.0)) {
    return fmt::format("{}: below 50 % at every slip force.", joint.name);
  }
  return fmt::format("{}: 50 % or more from {:.2g} to {:.3g} N.", joint.name, from, to);
}

}  // namespace

ReportSection modes_section(const ExperimentResults& results) {
  ReportSection section{.title = "Modes", .blocks = {}};
  if (!results.modal_levels) {
    section.blocks.emplace_back(ReportMissing{
        "No modes and no residuals: no calibration.csv in this folder.", kWriteAgain});
    return section;
  }
  const LevelsOfModes& levels = *results.modal_levels;
  if (has_modal_losses(results)) add_figure(section, modal_loss_figure(results));
  if (!levels.dissipation.empty() && !levels.measured_dissipation.empty()) {
    add_figure(section, modal_loss_error_figure(results));
  }
  if (has_modal_damping(results)) add_figure(section, modal_damping_figure(results));
  if (has_modal_frequencies(results)) add_figure(section, modal_frequency_figure(results));
  if (!levels.residual.empty()) add_figure(section, loss_residual_figure(results));
  if (!levels.frequency_residual.empty()) {
    add_figure(section, frequency_residual_figure(results));
  }
  section.blocks.emplace_back(modes_table(results));
  return section;
}

ReportSection joints_at_levels_section(const ExperimentResults& results) {
  ReportSection section{.title = "Joints at the levels", .blocks = {}};
  if (has_joint_amplitudes(results)) {
    for (Figure& figure : joint_amplitudes_figure(results).panels) {
      add_figure(section, std::move(figure));
    }
  }
  if (has_loss_shares(results)) {
    for (Figure& figure : loss_shares_figure(results).panels) {
      add_figure(section, std::move(figure));
    }
  }
  return section;
}

ReportSection identifiability_section(const ExperimentResults& results) {
  ReportSection section{.title = "Identifiability", .blocks = {}};
  if (has_variance_reduction(results)) {
    std::string text = "Variance reduction of each density by the levels.";
    for (const DensityFound& joint : results.densities) text += " " + determined_range_text(joint);
    section.blocks.emplace_back(ReportText{std::move(text)});
    add_figure(section, variance_reduction_figure(results));
    for (std::size_t j = 0; j < results.densities.size(); ++j) {
      add_figure(section, density_with_prior_figure(results, j));
    }
  }
  if (results.calibration && !results.calibration->pairs.empty()) {
    section.blocks.emplace_back(pairs_table(*results.calibration));
  }
  return section;
}

}  // namespace microslip
