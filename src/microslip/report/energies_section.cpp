// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "microslip/joint/dissipation.hpp"
#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

ReportFigure energies_figure(const ExperimentResults& results) {
  ReportFigure figure{
      .title = "Energies per cycle",
      .caption =
          results.levels->input_energy.empty()
              ? "What the levels give, and the same by the identified joint. [AR14 Fig. 8]"
              : "Input energy, what the linear damping of the structure takes of it, and what "
                "is left for the joint. [AR14 Fig. 8]",
      .x = amplitude_axis(true),
      .y = {.label = "energy per cycle", .unit = "mJ", .log = true, .log_switch = true},
      .choices = {{"", {}}},
      .wide = true};
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  const MeasuredLevels& test = *results.levels;
  const auto add = [&](const char* name, const std::vector<double>& values,
                       const std::vector<double>& std, int colour) {
    if (values.empty()) return;
    traces.push_back(
        at_levels(results, name, in_unit(values, kMillijoule), in_unit(std, kMillijoule), colour));
  };
  add("input energy", test.input_energy, {}, kGrey);
  add("linear loss", test.linear_dissipation, {}, kOrange);
  add("dissipation D", test.levels.dissipation, test.levels.dissipation_std, kBlack);
  std::vector<ReportTrace> curves = curves_of_joints(results, dissipation, kMillijoule, true);
  const double beta = results.joint ? results.joint->linear_damping.value_or(0.0) : 0.0;
  if (beta > 0.0) {
    curves.push_back({.name = "linear damping βA²",
                      .x = curves.front().x,
                      .y = in_unit(damping_curve(curve_amplitudes(test.levels), beta), kMillijoule),
                      .stroke = {.colour = kGreen, .style = LineStyle::kDotted, .width = 1.6}});
  }
  std::ranges::move(curves, std::back_inserter(traces));
  return figure;
}

ReportFigure share_figure(const ExperimentResults& results) {
  const std::vector<double> share = in_unit(linear_share(*results.levels), kPercent);
  return {
      .title = "Share of the linear loss",
      .caption = "Where it is near 100 %, D is a small difference of large energies.",
      .x = amplitude_axis(),
      .y = {.label = "linear loss over input energy", .unit = "%", .range = AxisRange{0.0, 100.0}},
      .choices = {{"", {at_levels(results, "linear loss", share, {}, kOrange)}}}};
}

ReportFigure residual_figure(const ExperimentResults& results) {
  const MeasuredPoints residual = relative_residuals(results);
  return {.title = "Residuals of D",
          .caption = residual.std.empty()
                         ? "Measured less identified, relative to the measured."
                         : "Measured less identified, relative to the measured; bars are ± one "
                           "standard deviation of the measured.",
          .x = amplitude_axis(true),
          .y = {.label = "(D − identified)/D", .unit = "%"},
          .choices = {{"",
                       {at_levels(results, "levels", in_unit(residual.value, kPercent),
                                  in_unit(residual.std, kPercent), kBlack)}}}};
}

std::string standardised_caption(const ExperimentResults& results) {
  const bool by_amplitude = !results.levels->levels.amplitude_std.empty();
  return fmt::format(
      "σ is that of D{}. Their rms is {:.2f}: near 1 the scatter explains them, but for what the "
      "fit takes up of it. A run of one sign is a misfit of the joint.",
      by_amplitude ? ", and of A through the slope of D, as in the identification" : "",
      misfit_of_levels(results).rms);
}

/// What is left in units of what the scatter over the cycles explains.
ReportFigure standardised_figure(const ExperimentResults& results,
                                 const std::vector<double>& deviation) {
  const auto [lowest, highest] = std::ranges::minmax(results.levels->levels.amplitude);
  const std::vector<double> ends = {lowest / kMicrometre, highest / kMicrometre};
  const auto limit = [&](const char* name, double at) {
    return ReportTrace{.name = name,
                       .x = ends,
                       .y = {at, at},
                       .stroke = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}};
  };
  const std::vector<double> residual = residuals_over(results, deviation);
  return {.title = "Standardised residuals",
          .caption = standardised_caption(results),
          .x = amplitude_axis(),
          .y = {.label = "(D − identified)/σ", .unit = "1"},
          .choices = {{"",
                       {limit("+2", 2.0), limit("−2", -2.0),
                        at_levels(results, "levels", residual, {}, kBlack)}}}};
}

/// Exact levels of a virtual test against the reduced ones.
ReportFigure truth_figure(const Curve& errors) {
  return {.title = "Error of the reduction",
          .caption = "D of the levels against that of the virtual test, which is known.",
          .x = amplitude_axis(true),
          .y = {.label = "D/exact − 1", .unit = "%"},
          .choices = {{"",
                       {{.name = "D",
                         .kind = TraceKind::kPoints,
                         .x = in_unit(errors.x, kMicrometre),
                         .y = in_unit(errors.y, kPercent),
                         .stroke = {.colour = kVermillion}}}}}};
}

}  // namespace

ReportSection energies_section(const ExperimentResults& results) {
  ReportSection section{.title = "Energies", .blocks = {}};
  if (!results.levels) return section;
  const MeasuredLevels& test = *results.levels;
  section.blocks.emplace_back(energies_figure(results));
  if (results.joint) {
    section.blocks.emplace_back(residual_figure(results));
    const std::vector<double> deviation = dissipation_deviations(results);
    if (!deviation.empty()) {
      section.blocks.emplace_back(standardised_figure(results, deviation));
    }
  }
  if (!test.input_energy.empty() && !test.linear_dissipation.empty()) {
    section.blocks.emplace_back(share_figure(results));
  }
  if (results.true_levels) {
    const Curve errors = reduction_errors(test, *results.true_levels);
    if (!errors.x.empty()) section.blocks.emplace_back(truth_figure(errors));
  }
  return section;
}

}  // namespace microslip
