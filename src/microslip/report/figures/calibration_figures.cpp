// SPDX-License-Identifier: MIT
#include "microslip/report/figures/calibration_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/calibration_layers.hpp"
#include "microslip/workflow/results/drawn_samples.hpp"

namespace microslip {
namespace {

constexpr const char* kSlipForce = "slip force f*";
constexpr const char* kDensity = "density φ";
constexpr const char* kDisplacement = "displacement at the response point";
constexpr const char* kMarksAndLines = "Marks are measured, lines found.";
/// Stroke of reference lines.
constexpr Stroke kThinDashes = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.0};

const LevelsOfModes& modes_of(const ExperimentResults& results) {
  if (!results.modal_levels) throw_missing("levels of modes", "the figure needs them");
  return *results.modal_levels;
}

/// Whether levels of modes have a column or another.
bool has_either(const ExperimentResults& results, std::vector<double> LevelsOfModes::*one,
                std::vector<double> LevelsOfModes::*other) {
  if (!results.modal_levels) return false;
  const LevelsOfModes& levels = *results.modal_levels;
  return !(levels.*one).empty() || !(levels.*other).empty();
}

/// Height of the axis: the largest density except at its first knots, where it may be
/// unbounded and hardly anything slips.
double shown_height(const std::vector<DensityFound>& joints) {
  constexpr double kFirst = 0.02;  // of the slip forces
  double highest = 0.0;
  for (const DensityFound& joint : joints) {
    const std::vector<double>& values = joint.upper.empty() ? joint.density : joint.upper;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (joint.slip_force[i] < kFirst * joint.slip_force.back()) continue;
      highest = std::max(highest, values[i]);
    }
  }
  return highest;
}

Figure density_panel(const std::vector<DensityFound>& joints, std::vector<Layer> layers) {
  Figure figure{.layers = std::move(layers)};
  check_figure(figure);
  double end = 0.0;
  for (const DensityFound& joint : joints) end = std::max(end, joint.slip_force.back());
  figure.x.range = AxisRange{0.0, 1.02 * end};
  const double height = shown_height(joints);
  if (height > 0.0) figure.y.range = AxisRange{0.0, 1.05 * height};
  show_x(figure, kSlipForce, "N");
  show_y(figure, kDensity, shown_unit("1/N", height));
  figure.x.log_switch = figure.y.log_switch = true;
  return figure;
}

std::string prior_caption(const std::vector<DensityFound>& joints) {
  const auto has_reduction = [](const DensityFound& joint) {
    return !joint.variance_reduction.empty();
  };
  if (std::ranges::none_of(joints, has_reduction)) return {};
  return " It is grey where the variance reduction is below 50 %: the density is continued "
         "smoothly there, by the prior.";
}

/// Figure over the displacement. @throws InputError  without layers.
Figure over_displacement(std::vector<Layer> layers, const char* missing,
                         const FigureOptions& options) {
  if (layers.empty()) throw_missing(missing, "the figure needs them");
  Figure figure{.layers = std::move(layers)};
  check_figure(figure);
  show_x(figure, kDisplacement, "m");
  figure.x.log = is_log(options, true);
  figure.x.log_switch = true;
  return figure;
}

std::vector<double> ratio_less_one(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratio;
  for (std::size_t i = 0; i < a.size(); ++i) ratio.push_back(a[i] / b[i] - 1.0);
  return ratio;
}

std::vector<double> over(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratio;
  for (std::size_t i = 0; i < a.size(); ++i) ratio.push_back(a[i] / b[i]);
  return ratio;
}

/// A thin line at y over all displacements.
LineLayer level_line(const LevelsOfModes& levels, double y, std::string legend = {}) {
  const auto [from, to] = std::ranges::minmax(levels.displacement);
  return {{from, to}, {y, y}, std::move(legend), kThinDashes};
}

/// Reference frequency of a mode, and its offset.
struct FrequencyBase {
  double frequency = 0.0;  // Hz
  double offset = 0.0;     // of the measured ones, relative
};

FrequencyBase base_of(const LevelsOfModes& levels, const RowsOfMode& mode, bool with_offset) {
  if (levels.frequency.empty()) return {levels.measured_frequency[mode.rows.front()], 0.0};
  FrequencyBase base{levels.frequency[mode.rows.front()], 0.0};
  if (!with_offset || levels.measured_frequency.empty()) return base;
  for (const std::size_t row : mode.rows) {
    base.offset += levels.measured_frequency[row] / levels.frequency[row] - 1.0;
  }
  base.offset /= static_cast<double>(mode.rows.size());
  return base;
}

Figure residual_figure(const LevelsOfModes& levels, const std::vector<double>& values,
                       const char* label, const FigureOptions& options) {
  std::vector<Layer> layers;
  add_marks(layers, levels, values);
  if (!layers.empty()) {
    for (const double at : {-2.0, 2.0})
      layers.emplace_back(level_line(levels, at, "± 2 deviations"));
  }
  Figure figure = over_displacement(std::move(layers), "residuals", options);
  show_y(figure, label, "1");
  figure.caption =
      "Over the scatter found: noise is even within ± 2; waves and trends are what the "
      "joints do not explain.";
  return figure;
}

/// Grid with a panel per joint.
template <class Add>
FigureGrid panel_per_joint(const LevelsOfModes& levels, const FigureOptions& options,
                           const Add& add) {
  FigureGrid grid{"", 2, {}};
  for (const JointOverLevels& joint : levels.joints) {
    std::vector<Layer> layers;
    add(joint, layers);
    if (layers.empty()) continue;
    Figure figure = over_displacement(std::move(layers), "joints", options);
    figure.title = joint.name;
    figure.subtitle = joint.name;
    grid.panels.push_back(std::move(figure));
  }
  if (grid.panels.empty()) throw_missing("joints", "the figure needs their columns");
  return grid;
}

}  // namespace

bool has_variance_reduction(const ExperimentResults& results) {
  return std::ranges::any_of(results.densities, [](const DensityFound& joint) {
    return !joint.variance_reduction.empty();
  });
}

bool has_modal_losses(const ExperimentResults& results) {
  return has_either(results, &LevelsOfModes::measured_dissipation, &LevelsOfModes::dissipation);
}

bool has_modal_damping(const ExperimentResults& results) {
  return has_either(results, &LevelsOfModes::measured_damping_ratio, &LevelsOfModes::damping_ratio);
}

bool has_modal_frequencies(const ExperimentResults& results) {
  return has_either(results, &LevelsOfModes::measured_frequency, &LevelsOfModes::frequency);
}

bool has_modal_residuals(const ExperimentResults& results) {
  return has_either(results, &LevelsOfModes::residual, &LevelsOfModes::frequency_residual);
}

bool has_joint_amplitudes(const ExperimentResults& results) {
  return results.modal_levels &&
         std::ranges::any_of(results.modal_levels->joints, [](const JointOverLevels& joint) {
           return !joint.amplitude.empty() || !joint.measured_amplitude.empty();
         });
}

bool has_loss_shares(const ExperimentResults& results) {
  return results.modal_levels && !results.modal_levels->dissipation.empty() &&
         std::ranges::any_of(results.modal_levels->joints, [](const JointOverLevels& joint) {
           return !joint.dissipation.empty();
         });
}

Figure densities_figure(const ExperimentResults& results, const FigureOptions& /*options*/) {
  if (results.densities.empty()) throw_missing("densities", "the figure needs them");
  std::vector<Layer> layers;
  const std::vector<DensityFound>& joints = results.densities;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    std::ranges::move(density_layers(joints[j], j, joints[j].name), std::back_inserter(layers));
  }
  // Lines over all bands.
  std::ranges::stable_partition(
      layers, [](const Layer& layer) { return std::holds_alternative<BandLayer>(layer); });
  for (Layer& layer : layers) {
    auto* band = std::get_if<BandLayer>(&layer);
    if (band != nullptr && band->colour != kGrey) band->legend = "";
  }
  Figure figure = density_panel(joints, std::move(layers));
  figure.title = joints.size() > 1 ? "Slip-force densities" : "Slip-force density";
  figure.caption = "Lines with their pointwise bands." + prior_caption(joints);
  return figure;
}

Figure density_with_prior_figure(const ExperimentResults& results, std::size_t joint) {
  const DensityFound& shown = results.densities.at(joint);
  Figure figure = density_panel({shown}, density_layers(shown, joint, shown.name));
  figure.title = fmt::format("Density of {}", shown.name);
  figure.caption = "With its band." + prior_caption({shown});
  return figure;
}

Figure variance_reduction_figure(const ExperimentResults& results) {
  constexpr double kDecades = 1e-3;  // of the largest slip force: the curve is flat below
  Figure figure{.title = "Variance reduction"};
  double from = std::numeric_limits<double>::infinity();
  double to = 0.0;
  for (std::size_t j = 0; j < results.densities.size(); ++j) {
    const DensityFound& joint = results.densities[j];
    if (joint.variance_reduction.empty()) continue;
    figure.layers.emplace_back(
        LineLayer{joint.slip_force, joint.variance_reduction, joint.name, stroke_of(j)});
    for (const double force : joint.slip_force) {
      if (force > 0.0) from = std::min(from, force);
      to = std::max(to, force);
    }
  }
  if (figure.layers.empty())
    throw_missing("variance reduction", "the figure needs identifiability.csv");
  from = std::max(from, kDecades * to);
  figure.layers.emplace_back(
      LineLayer{{from, to}, {kDetermined, kDetermined}, "half", kThinDashes});
  check_figure(figure);
  figure.x.range = AxisRange{from, 1.1 * to};
  figure.y.range = AxisRange{0.0, 1.05};
  show_x(figure, kSlipForce, "N");
  show_y(figure, "variance reduction", "1");
  figure.x.log = true;
  figure.x.log_switch = true;
  figure.caption =
      "Share of the prior variance of the density that the levels removed: 1 where they determine "
      "it, 0 where they do not.";
  return figure;
}

FigureGrid identifiability_figure(const ExperimentResults& results,
                                  const FigureOptions& /*options*/) {
  FigureGrid grid{"", results.densities.size() == 2 ? std::size_t{3} : std::size_t{2}, {}};
  for (std::size_t j = 0; j < results.densities.size(); ++j) {
    grid.panels.push_back(density_with_prior_figure(results, j));
  }
  grid.panels.push_back(variance_reduction_figure(results));
  return grid;
}

Figure modal_loss_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  std::vector<Layer> layers;
  add_lines(layers, levels, levels.dissipation);
  add_marks(layers, levels, levels.measured_dissipation, levels.measured_dissipation_std);
  Figure figure = over_displacement(std::move(layers), "losses", options);
  figure.title = "Loss per cycle";
  figure.caption = levels.dissipation.empty() ? "Of all joints together." : kMarksAndLines;
  show_y(figure, "dissipation of all joints", "J");
  figure.y.log = figure.x.log;
  figure.y.log_switch = true;
  return figure;
}

Figure modal_loss_error_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  std::vector<Layer> layers;
  if (!levels.dissipation.empty() && !levels.measured_dissipation.empty()) {
    add_marks(layers, levels, ratio_less_one(levels.measured_dissipation, levels.dissipation),
              over(levels.measured_dissipation_std, levels.dissipation));
    layers.emplace_back(level_line(levels, 0.0));
  }
  Figure figure = over_displacement(std::move(layers), "losses, measured and found,", options);
  figure.title = "Loss, measured against found";
  figure.caption = levels.measured_dissipation_std.empty()
                       ? "Measured over found, less 1."
                       : "Measured over found, less 1; bars are one standard deviation.";
  show_y(figure, "measured less found loss", "%");
  return figure;
}

Figure modal_damping_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  std::vector<Layer> layers;
  add_lines(layers, levels, levels.damping_ratio);
  add_marks(layers, levels, levels.measured_damping_ratio, levels.measured_damping_ratio_std);
  Figure figure = over_displacement(std::move(layers), "damping ratios", options);
  figure.title = "Damping ratio";
  figure.caption = "Of the structure with its joints.";
  if (!levels.damping_ratio.empty()) {
    figure.caption += levels.measured_damping_ratio.empty()
                          ? " As computed: the loss of the joints was measured, not the ratio."
                          : std::string(" ") + kMarksAndLines;
  }
  show_y(figure, "damping ratio ζ", "%");
  figure.y.log_switch = true;
  return figure;
}

Figure modal_frequency_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  const bool absolute = results.calibration && results.calibration->frequency_use == "absolute";
  std::vector<double> measured(levels.measured_frequency.size());
  std::vector<double> std = levels.measured_frequency_std;
  std::vector<double> found(levels.frequency.size());
  if (has_modal_frequencies(results)) {
    for (const RowsOfMode& mode : rows_by_mode(levels)) {
      const FrequencyBase base = base_of(levels, mode, !absolute);
      for (const std::size_t row : mode.rows) {
        if (!found.empty()) found[row] = levels.frequency[row] / base.frequency - 1.0;
        if (measured.empty()) continue;
        measured[row] =
            levels.measured_frequency[row] / (base.frequency * (1.0 + base.offset)) - 1.0;
        if (!std.empty()) std[row] /= base.frequency;
      }
    }
  }
  std::vector<Layer> layers;
  add_lines(layers, levels, found);
  add_marks(layers, levels, measured, std);
  Figure figure = over_displacement(std::move(layers), "frequencies", options);
  figure.title = "Frequency";
  figure.caption = "Over that of the lowest level of each mode, less 1.";
  if (!found.empty()) {
    figure.caption += absolute ? std::string(" ") + kMarksAndLines
                               : " Marks are measured, less the mean offset of their mode; lines "
                                 "found.";
  }
  show_y(figure, "change of frequency", "%");
  return figure;
}

Figure loss_residual_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  Figure figure = residual_figure(levels, levels.residual, "residual of the loss", options);
  figure.title = "Residuals of the losses";
  return figure;
}

Figure frequency_residual_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  Figure figure =
      residual_figure(levels, levels.frequency_residual, "residual of the frequency", options);
  figure.title = "Residuals of the frequencies";
  return figure;
}

FigureGrid joint_amplitudes_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  FigureGrid grid = panel_per_joint(
      levels, options, [&](const JointOverLevels& joint, std::vector<Layer>& layers) {
        add_lines(layers, levels, over(joint.amplitude, levels.displacement));
        add_marks(layers, levels, over(joint.measured_amplitude, levels.displacement));
      });
  for (Figure& figure : grid.panels) {
    figure.title = fmt::format("Displacement of {}", figure.subtitle);
    figure.caption =
        "Half range across the joint over the displacement at the response point: it changes with "
        "the shape of the mode, as joints slip.";
    show_y(figure, "joint over response", "1");
  }
  return grid;
}

FigureGrid loss_shares_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  FigureGrid grid = panel_per_joint(
      levels, options, [&](const JointOverLevels& joint, std::vector<Layer>& layers) {
        if (joint.dissipation.empty() || levels.dissipation.empty()) return;
        add_bands(layers, levels, over(joint.dissipation_lower, levels.dissipation),
                  over(joint.dissipation_upper, levels.dissipation));
        add_lines(layers, levels, over(joint.dissipation, levels.dissipation));
      });
  for (Figure& figure : grid.panels) {
    figure.title = fmt::format("Share of {} in the loss", figure.subtitle);
    figure.caption = "Of the loss of all joints together, with its own band.";
    show_y(figure, "share of the loss", "%");
  }
  return grid;
}

FigureGrid modal_losses_figure(const ExperimentResults& results, const FigureOptions& options) {
  FigureGrid grid{"", 2, {}};
  if (has_modal_losses(results)) grid.panels.push_back(modal_loss_figure(results, options));
  const bool both = results.modal_levels && !results.modal_levels->dissipation.empty() &&
                    !results.modal_levels->measured_dissipation.empty();
  if (both) grid.panels.push_back(modal_loss_error_figure(results, options));
  if (grid.panels.empty()) throw_missing("losses", "the figure needs them");
  return grid;
}

FigureGrid modal_residuals_figure(const ExperimentResults& results, const FigureOptions& options) {
  const LevelsOfModes& levels = modes_of(results);
  FigureGrid grid{"", 2, {}};
  if (!levels.residual.empty()) grid.panels.push_back(loss_residual_figure(results, options));
  if (!levels.frequency_residual.empty()) {
    grid.panels.push_back(frequency_residual_figure(results, options));
  }
  if (grid.panels.empty()) throw_missing("residuals", "the figure needs them");
  return grid;
}

Figure draws_figure(const JointSamples& samples, const FigureOptions& /*options*/) {
  constexpr std::size_t kMostDrawn = 40;
  const SampledDensities sampled = sampled_densities(samples, kMostDrawn);
  const DensityFound& found = sampled.found;
  std::vector<Layer> layers;
  layers.emplace_back(BandLayer{found.slip_force, found.lower, found.upper,
                                fmt::format("95 % band of {} draws", samples.size()), kSkyBlue});
  for (const std::vector<double>& draw : sampled.drawn) {
    layers.emplace_back(LineLayer{found.slip_force,
                                  draw,
                                  fmt::format("{} of them", sampled.drawn.size()),
                                  {.colour = kGrey, .width = 0.5}});
  }
  layers.emplace_back(LineLayer{found.slip_force, found.density, "mean", kFound});
  for (const double atom : sampled.atom_slip_force) {
    layers.emplace_back(MarkerLayer{.x = atom, .label = "atom"});
  }
  Figure figure = density_panel({found}, std::move(layers));
  figure.title = "Draws of the density";
  return figure;
}

}  // namespace microslip
