// SPDX-License-Identifier: MIT
#include <utility>
#include <vector>

#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

/// Damping ratio of the structure with its joint.
Figure structure_damping_figure(const ExperimentResults& results) {
  Figure figure{.title = "Damping of the structure",
                .caption =
                    "Damping ratio in phase resonance, predicted for the rig: by the energy "
                    "that a cycle loses in structure and joint."};
  const auto add = [&](const JointBackbone& backbone, const char* legend, const Stroke& stroke) {
    figure.layers.emplace_back(
        LineLayer{backbone.amplitude, backbone.damping_ratio, legend, stroke});
  };
  add(*results.backbone, kPredictedByJoint, kFound);
  if (results.true_backbone) add(*results.true_backbone, kPredictedByTruth, kTruth);
  if (const std::vector<double> measured = measured_damping(results); !measured.empty()) {
    figure.caption += " Measured: the input energy over the energy of that vibration.";
    figure.layers.emplace_back(at_levels(*results.levels, {measured, {}}, "measured"));
  }
  show_amplitude(figure, {}, false);
  show_y(figure, "damping ratio ζ", "%");
  figure.y.log_switch = true;
  return figure;
}

}  // namespace

ReportSection stiffness_section(const ExperimentResults& results) {
  ReportSection section{.title = "Stiffness and damping", .blocks = {}};
  if (!results.levels) return section;
  const MeasuredLevels& test = *results.levels;
  const auto add = [&](Figure figure) {
    section.blocks.emplace_back(ReportFigure{.figure = std::move(figure)});
  };
  if (!test.resonance_frequency.empty() || !test.frequency.empty()) {
    add(resonance_figure(results, {}, FrequencyOver::kAmplitude));
  }
  if (results.joint || results.truth || !test.levels.secant_stiffness.empty()) {
    add(stiffness_figure(results));
    add(damping_figure(results));
  }
  if (results.backbone) add(structure_damping_figure(results));
  if (section.blocks.empty()) {
    section.blocks.emplace_back(
        ReportMissing{"No stiffness and damping: the levels have neither resonance frequencies nor "
                      "secant stiffnesses, and there is no joint."});
  }
  return section;
}

}  // namespace microslip
