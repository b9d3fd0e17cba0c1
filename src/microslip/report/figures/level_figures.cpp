// SPDX-License-Identifier: MIT
#include "microslip/report/figures/level_figures.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"

namespace microslip {
namespace {

/// A quantity that a joint has at an amplitude.
struct PlottedQuantity {
  const char* title;
  const char* caption;
  const char* label;
  const char* unit;  // SI
  JointQuantity value;
  bool energy = false;  // its axis is logarithmic where that of the amplitude is
};

constexpr PlottedQuantity kDissipation{
    "Dissipation of the joint",
    "Energy dissipated per cycle over the amplitude of the displacement.",
    "dissipation per cycle D",
    "J",
    dissipation,
    true};
constexpr PlottedQuantity kSecant{"Secant stiffness",
                                  "Of the first harmonic. The absolute level of a measured one "
                                  "depends on k; its change over the amplitude does not.",
                                  "secant stiffness k_eq", "N/m", secant_stiffness};
constexpr PlottedQuantity kLossFactor{"Loss factor of the joint",
                                      "D/(π k_eq A²): it rises with micro-slip, and falls again "
                                      "beyond macro-slip where a part of the stiffness never "
                                      "slips.",
                                      "loss factor η", "1", loss_factor};

/// A quantity over the amplitude: measured, where it was, and by the joints.
Figure over_amplitude(const ExperimentResults& results, const FigureOptions& options,
                      const PlottedQuantity& quantity, const MeasuredPoints& measured) {
  Figure figure{.title = quantity.title, .caption = quantity.caption, .layers = options.beside};
  add_curves(figure, results, options, quantity.value);
  if (quantity.energy) add_with_damping(figure, results);
  if (!measured.value.empty()) {
    figure.layers.emplace_back(at_levels(levels_of(results), measured, "measured"));
  }
  show_amplitude(figure, options, quantity.energy);
  show_y(figure, quantity.label, quantity.unit);
  figure.y.log = figure.x.log && quantity.energy;
  figure.y.log_switch = true;
  return figure;
}

MeasuredPoints measured_dissipation(const ExperimentResults& results) {
  if (!results.levels) return {};
  return {results.levels->levels.dissipation, results.levels->levels.dissipation_std};
}

MeasuredPoints measured_secant(const ExperimentResults& results) {
  if (!results.levels) return {};
  return {results.levels->levels.secant_stiffness, results.levels->levels.secant_stiffness_std};
}

/// ζ of the mode, of a ring-down.
Figure damping_ratios(const MeasuredLevels& levels, const FigureOptions& options) {
  Figure figure{.title = "Damping of the mode",
                .layers = {at_levels(levels, {levels.damping_ratio, {}}, "")}};
  show_amplitude(figure, options, false);
  show_y(figure, "damping ratio ζ of the mode", "%");
  return figure;
}

void add_predicted(Figure& figure, const std::optional<JointBackbone>& backbone, const char* legend,
                   const Stroke& stroke) {
  if (!backbone) return;
  figure.layers.emplace_back(LineLayer{backbone->amplitude, backbone->frequency, legend, stroke});
}

}  // namespace

Figure energies_figure(const ExperimentResults& results, const FigureOptions& options) {
  const MeasuredLevels& test = levels_of(results);
  Figure figure{
      .title = "Energies per cycle",
      .caption = test.input_energy.empty()
                     ? "Measured by the levels, and computed from the joint. [AR14 Fig. 8]"
                     : "Input energy, the loss of it in the linear damping of the structure, and "
                       "the remainder in the joint. [AR14 Fig. 8]",
      .layers = options.beside};
  add_curves(figure, results, options, dissipation);
  add_with_damping(figure, results);
  if (!test.input_energy.empty()) {
    figure.layers.emplace_back(at_levels(test, {test.input_energy, {}}, "input energy", kGrey));
  }
  if (!test.linear_dissipation.empty()) {
    figure.layers.emplace_back(
        at_levels(test, {test.linear_dissipation, {}}, "linear loss", kOrange));
  }
  const bool damped = results.joint && results.joint->linear_damping;
  figure.layers.emplace_back(
      at_levels(test, measured_dissipation(results), damped ? "D, with damping βA²" : "joint, D"));
  show_amplitude(figure, options, true);
  show_y(figure, "energy per cycle", "J");
  figure.y.log = figure.x.log;
  figure.y.log_switch = true;
  return figure;
}

Figure linear_share_figure(const ExperimentResults& results, const FigureOptions& options) {
  const MeasuredLevels& test = levels_of(results);
  if (test.input_energy.empty() || test.linear_dissipation.empty()) {
    throw_missing("levels.linear_dissipation", "the figure needs input energy and linear loss");
  }
  Figure figure{.title = "Share of the linear loss",
                .caption = "Where it is near 100 %, D is a small difference of large energies.",
                .y = {.range = AxisRange{0.0, 1.0}},
                .layers = options.beside};
  figure.layers.emplace_back(at_levels(test, {linear_share(test), {}}, "linear loss", kOrange));
  show_amplitude(figure, options, false);
  show_y(figure, "linear loss over input energy", "%");
  return figure;
}

Figure dissipation_figure(const ExperimentResults& results, const FigureOptions& options) {
  (void)joint_of(results);
  return over_amplitude(results, options, kDissipation, measured_dissipation(results));
}

Figure stiffness_figure(const ExperimentResults& results, const FigureOptions& options) {
  return over_amplitude(results, options, kSecant, measured_secant(results));
}

Figure damping_figure(const ExperimentResults& results, const FigureOptions& options) {
  const MeasuredPoints measured = measured_loss_factor(results);
  if (!results.joint && measured.value.empty() && !levels_of(results).damping_ratio.empty()) {
    return damping_ratios(*results.levels, options);
  }
  return over_amplitude(results, options, kLossFactor, measured);
}

FigureGrid joint_figures(const ExperimentResults& results, const FigureOptions& options) {
  FigureGrid grid{"",
                  3,
                  {dissipation_figure(results, options), stiffness_figure(results, options),
                   over_amplitude(results, options, kLossFactor, measured_loss_factor(results))}};
  for (std::size_t i = 1; i < grid.panels.size(); ++i) {
    grid.panels[i].legend = Legend::kNone;  // that of the first serves all
  }
  return grid;
}

Figure resonance_figure(const ExperimentResults& results, const FigureOptions& options,
                        FrequencyOver over) {
  const MeasuredLevels& levels = levels_of(results);
  const bool over_response = over == FrequencyOver::kResponse && !levels.response_amplitude.empty();
  const bool measured = !levels.resonance_frequency.empty();
  Figure figure{
      .title = "Resonance frequency",
      .caption = measured
                     ? "From the measured phase of the response, not from the setting of the drive."
                     : "The frequency of the drive: that of the resonance as far as the test kept "
                       "the phase at resonance.",
      .layers = options.beside};
  const auto add = [&](const std::vector<double>& frequency, std::string legend, int colour) {
    PointLayer points = at_levels(levels, {frequency, {}}, std::move(legend), colour);
    points.open = colour == kBlack;
    if (over_response) points.x = levels.response_amplitude;
    figure.layers.emplace_back(std::move(points));
  };
  if (!over_response) {
    add_predicted(figure, results.backbone, kPredictedByJoint, kFound);
    add_predicted(figure, results.true_backbone, kPredictedByTruth, kTruth);
  }
  if (!levels.frequency.empty()) add(levels.frequency, "drive", measured ? kOrange : kBlack);
  if (measured) add(levels.resonance_frequency, "resonance", kBlack);
  if (!measured && levels.frequency.empty()) {
    throw_missing("levels.frequency", "the figure needs frequencies of the levels");
  }
  if (over_response) {
    show_response(figure, options, false);
  } else {
    show_amplitude(figure, options, false);
  }
  show_y(figure, "frequency", "Hz");
  return figure;
}

}  // namespace microslip
