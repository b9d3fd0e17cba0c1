// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

Figure residual_figure(const ExperimentResults& results) {
  MeasuredPoints residual = relative_residuals(results);
  Figure figure{.title = "Residuals of D",
                .caption = residual.std.empty()
                               ? "Measured less identified, relative to the measured."
                               : "Measured less identified, relative to the measured; bars are ± "
                                 "one standard deviation of the measured.",
                .layers = {at_levels(*results.levels, residual, "levels")}};
  show_amplitude(figure, {}, true);
  show_y(figure, "(D − identified)/D", "%");
  return figure;
}

std::string standardised_caption(const ExperimentResults& results) {
  const bool by_amplitude = !results.levels->levels.amplitude_std.empty();
  return fmt::format(
      "σ is that of D{}. Their rms is {:.2f}: near 1 the scatter explains them, except what the "
      "fit absorbs. A run of one sign is a misfit of the joint.",
      by_amplitude ? ", and of A through the slope of D, as in the identification" : "",
      misfit_of_levels(results).rms);
}

/// Residuals over the standard deviation due to the scatter over the cycles.
Figure standardised_figure(const ExperimentResults& results, const std::vector<double>& deviation) {
  Figure figure{.title = "Standardised residuals", .caption = standardised_caption(results)};
  const auto [lowest, highest] = std::ranges::minmax(results.levels->levels.amplitude);
  for (const auto& [name, at] : {std::pair{"+2", 2.0}, std::pair{"−2", -2.0}}) {
    figure.layers.emplace_back(
        LineLayer{{lowest, highest},
                  {at, at},
                  name,
                  {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}});
  }
  figure.layers.emplace_back(
      at_levels(*results.levels, {residuals_over(results, deviation), {}}, "levels"));
  show_amplitude(figure, {}, false);
  show_y(figure, "(D − identified)/σ", "1");
  return figure;
}

/// Error of the reduced levels against the exact ones of a virtual test.
Figure truth_figure(const Curve& errors) {
  Figure figure{
      .title = "Error of the reduction",
      .caption = "D of the levels against that of the virtual test, which is known.",
      .layers = {PointLayer{.x = errors.x, .y = errors.y, .legend = "D", .colour = kVermillion}}};
  show_amplitude(figure, {}, true);
  show_y(figure, "D/exact − 1", "%");
  return figure;
}

}  // namespace

ReportSection energies_section(const ExperimentResults& results) {
  ReportSection section{.title = "Energies", .blocks = {}};
  if (!results.levels) return section;
  const MeasuredLevels& test = *results.levels;
  const auto add = [&](Figure figure, bool wide = false) {
    section.blocks.emplace_back(ReportFigure{.figure = std::move(figure), .wide = wide});
  };
  add(energies_figure(results), true);
  if (results.joint) {
    add(residual_figure(results));
    const std::vector<double> deviation = dissipation_deviations(results);
    if (!deviation.empty()) add(standardised_figure(results, deviation));
  }
  if (!test.input_energy.empty() && !test.linear_dissipation.empty()) {
    add(linear_share_figure(results));
  }
  if (results.true_levels) {
    const Curve errors = reduction_errors(test, *results.true_levels);
    if (!errors.x.empty()) add(truth_figure(errors));
  }
  return section;
}

}  // namespace microslip
