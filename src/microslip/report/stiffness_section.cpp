// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/joint/secant.hpp"
#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

/// A quantity of the structure as predicted.
ReportTrace predicted(const JointBackbone& backbone, const std::vector<double>& values, double unit,
                      const char* name, Stroke stroke) {
  return {.name = name,
          .x = in_unit(backbone.amplitude, kMicrometre),
          .y = in_unit(values, unit),
          .stroke = stroke};
}

void add_predicted(const ExperimentResults& results, std::vector<double> JointBackbone::*values,
                   double unit, std::vector<ReportTrace>& traces) {
  const auto add = [&](const std::optional<JointBackbone>& backbone, const char* name,
                       Stroke stroke) {
    if (backbone) {
      traces.push_back(predicted(*backbone, (*backbone).*values, unit, name, stroke));
    }
  };
  add(results.backbone, "predicted by the joint", kFound);
  add(results.true_backbone, "by the true joint", kTruth);
}

ReportFigure resonance_figure(const ExperimentResults& results) {
  const MeasuredLevels& test = *results.levels;
  const bool measured = !test.resonance_frequency.empty();
  ReportFigure figure{
      .title = "Resonance frequency",
      .caption = measured
                     ? "From the measured phase of the response, not from the setting of the drive."
                     : "The frequency of the drive: that of the resonance as far as the test kept "
                       "the phase there.",
      .x = amplitude_axis(),
      .y = {.label = "frequency", .unit = "Hz"},
      .choices = {{"", {}}}};
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  if (!test.frequency.empty()) {
    traces.push_back(at_levels(results, "drive", test.frequency, {}, kSkyBlue));
  }
  if (measured) {
    traces.push_back(at_levels(results, "resonance", test.resonance_frequency, {}, kBlack));
  }
  add_predicted(results, &JointBackbone::frequency, 1.0, traces);
  return figure;
}

/// Of the structure with its joint.
ReportFigure structure_damping_figure(const ExperimentResults& results) {
  ReportFigure figure{.title = "Damping of the structure",
                      .caption =
                          "Damping ratio in phase resonance, predicted for the rig: by the energy "
                          "that a cycle loses in structure and joint.",
                      .x = amplitude_axis(),
                      .y = {.label = "damping ratio", .unit = "%", .log_switch = true},
                      .choices = {{"", {}}}};
  if (const std::vector<double> measured = measured_damping(results); !measured.empty()) {
    figure.caption += " Measured: the input energy over the energy of that vibration.";
    figure.choices[0].traces.push_back(
        at_levels(results, "measured", in_unit(measured, kPercent), {}, kBlack));
  }
  add_predicted(results, &JointBackbone::damping_ratio, kPercent, figure.choices[0].traces);
  return figure;
}

ReportFigure secant_figure(const ExperimentResults& results) {
  const Levels& levels = results.levels->levels;
  ReportFigure figure{.title = "Secant stiffness",
                      .caption = "Of the first harmonic.",
                      .x = amplitude_axis(),
                      .y = {.label = "k_eq", .unit = "kN/m"},
                      .choices = {{"", {}}}};
  if (!levels.secant_stiffness.empty()) {
    figure.caption +=
        " The absolute level of the measured one stands and falls with k; its change over the "
        "amplitude does not.";
  }
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  if (!levels.secant_stiffness.empty()) {
    traces.push_back(at_levels(results, "measured",
                               in_unit(levels.secant_stiffness, kKilonewtonPerMetre),
                               in_unit(levels.secant_stiffness_std, kKilonewtonPerMetre), kBlack));
  }
  std::ranges::move(curves_of_joints(results, secant_stiffness, kKilonewtonPerMetre),
                    std::back_inserter(traces));
  return figure;
}

ReportFigure loss_figure(const ExperimentResults& results) {
  ReportFigure figure{.title = "Loss factor of the joint",
                      .caption =
                          "D/(π k_eq A²): it rises with micro-slip, and falls again beyond "
                          "macro-slip where a part of the stiffness never slips.",
                      .x = amplitude_axis(),
                      .y = {.label = "loss factor", .unit = "1", .log_switch = true},
                      .choices = {{"", {}}}};
  std::vector<ReportTrace>& traces = figure.choices[0].traces;
  MeasuredPoints measured = measured_loss_factor(results);
  if (!measured.value.empty()) {
    traces.push_back(at_levels(results, "measured", std::move(measured.value), {}, kBlack));
  }
  std::ranges::move(curves_of_joints(results, loss_factor), std::back_inserter(traces));
  return figure;
}

}  // namespace

ReportSection stiffness_section(const ExperimentResults& results) {
  ReportSection section{.title = "Stiffness and damping", .blocks = {}};
  if (!results.levels) return section;
  const MeasuredLevels& test = *results.levels;
  const bool secant = results.joint || results.truth || !test.levels.secant_stiffness.empty();
  if (!test.resonance_frequency.empty() || !test.frequency.empty())
    section.blocks.emplace_back(resonance_figure(results));
  if (secant) {
    section.blocks.emplace_back(secant_figure(results));
    section.blocks.emplace_back(loss_figure(results));
  }
  if (results.backbone) section.blocks.emplace_back(structure_damping_figure(results));
  if (section.blocks.empty()) {
    section.blocks.emplace_back(
        ReportMissing{"No stiffness and damping: the levels have neither resonance frequencies nor "
                      "secant stiffnesses, and there is no joint."});
  }
  return section;
}

}  // namespace microslip
