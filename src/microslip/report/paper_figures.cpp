// SPDX-License-Identifier: MIT
#include "microslip/report/paper_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/report/paper_parts.hpp"
#include "microslip/report/sections.hpp"
#include "microslip/report/shown_unit.hpp"
#include "microslip/workflow/sampled_curves.hpp"

namespace microslip {
namespace {

constexpr const char* kResponseLabel = "exciter acceleration";

/// Those of the levels, what the identification covered, or what the joint can do; m.
AxisRange amplitude_range(const ExperimentResults& results) {
  if (results.levels) {
    const auto [lowest, highest] = std::ranges::minmax(results.levels->levels.amplitude);
    return {lowest, highest};
  }
  const IdentifiedJoint& found = joint_of(results);
  const double k = found.joint.stiffness();
  if (found.covered_from && found.covered_to && *found.covered_from > 0.0) {
    return {*found.covered_from / k, *found.covered_to / k};
  }
  const double end = macroslip_amplitude(found.joint);
  return {1e-3 * end, 2.0 * end};
}

/// A quantity that a joint has at an amplitude.
struct PlottedQuantity {
  const char* label;
  const char* unit;  // SI
  JointQuantity value;
  bool energy = false;  // its axis is logarithmic where that of the amplitude is
  bool suits_log = false;
};

constexpr PlottedQuantity kDissipation{"dissipation per cycle D", "J", dissipation, true, true};
constexpr PlottedQuantity kSecant{"secant stiffness k_eq", "N/m", secant_stiffness};
constexpr PlottedQuantity kLossFactor{"loss factor η", "1", loss_factor};

PointLayer points_of(const MeasuredLevels& levels, const MeasuredPoints& measured,
                     std::string legend, int colour = kBlack) {
  return {.x = levels.levels.amplitude,
          .y = measured.value,
          .y_error = measured.std,
          .legend = std::move(legend),
          .colour = colour,
          .open = true};
}

void add_curves(Figure& figure, const ExperimentResults& results, const PaperOptions& options,
                JointQuantity quantity) {
  const AxisRange range = amplitude_range(results);
  const std::vector<double> amplitude = equal_ratios(range.from, range.to);
  for (const DrawnJoint& drawn : drawn_joints(results, options)) {
    figure.layers.emplace_back(LineLayer{amplitude, joint_curve(drawn.joint, quantity, amplitude),
                                         drawn.name, drawn.stroke});
  }
}

/// D + βA²: what the levels hold where linear damping was identified beside the joint.
void add_with_damping(Figure& figure, const ExperimentResults& results) {
  if (!results.joint || !results.joint->linear_damping) return;
  const IdentifiedJoint& found = *results.joint;
  const AxisRange range = amplitude_range(results);
  const std::vector<double> amplitude = equal_ratios(range.from, range.to);
  figure.layers.emplace_back(
      LineLayer{amplitude,
                joint_curve(found.joint, dissipation, amplitude, *found.linear_damping),
                "with damping βA²",
                {.colour = kGreen, .style = LineStyle::kLongDashed}});
}

void show_amplitude(Figure& figure, const PaperOptions& options, bool suits_log) {
  show_x(figure, "joint amplitude A", "m");
  figure.x.log = is_log(options, suits_log);
}

/// A quantity over the amplitude: measured, where it was, and by the joints.
Figure over_amplitude(const ExperimentResults& results, const PaperOptions& options,
                      const PlottedQuantity& quantity, const MeasuredPoints& measured) {
  Figure figure;
  add_curves(figure, results, options, quantity.value);
  if (quantity.energy) add_with_damping(figure, results);
  if (!measured.value.empty()) {
    figure.layers.emplace_back(points_of(levels_of(results), measured, "measured"));
  }
  show_amplitude(figure, options, quantity.suits_log);
  show_y(figure, quantity.label, quantity.unit);
  figure.y.log = figure.x.log && quantity.energy;
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
Figure damping_ratios(const MeasuredLevels& levels, const PaperOptions& options) {
  Figure figure;
  figure.layers = {points_of(levels, {levels.damping_ratio, {}}, "")};
  show_amplitude(figure, options, false);
  show_y(figure, "damping ratio ζ of the mode", "%");
  return figure;
}

/// Of the loops that are drawn, m.
double largest_amplitude(const ExperimentResults& results) {
  if (results.levels) return std::ranges::max(results.levels->levels.amplitude);
  const IdentifiedJoint& found = joint_of(results);
  return found.covered_to ? *found.covered_to / found.joint.stiffness()
                          : 1.2 * macroslip_amplitude(found.joint);
}

LoopLayer loop_of(const Joint& joint, double amplitude, std::string legend, const Stroke& stroke) {
  SteadyLoop loop = steady_loop(joint, amplitude);
  return {std::move(loop.displacement), std::move(loop.force), std::move(legend), stroke};
}

/// Where a level is on the axis of the resonance.
const std::vector<double>& level_positions(const MeasuredLevels& levels) {
  return levels.response_amplitude.empty() ? levels.levels.amplitude : levels.response_amplitude;
}

PointLayer frequencies_of(const MeasuredLevels& levels, const std::vector<double>& frequency,
                          std::string legend, int colour) {
  return {.x = level_positions(levels),
          .y = frequency,
          .legend = std::move(legend),
          .colour = colour,
          .open = colour == kBlack};
}

/// Sliders of single slip forces alone, which have no density.
bool is_of_atoms(const SlipDensity& density) {
  const auto is_flat = [](const SlipDensity::LinearSegment& segment) {
    return segment.p == 0.0 && segment.q == 0.0;
  };
  return !density.atoms().weight.empty() && density.power_laws().empty() &&
         std::ranges::all_of(density.segments(), is_flat);
}

/// Φ0(f*), which has steps where a density has atoms.
Figure slipped_shares(const std::vector<DrawnJoint>& joints) {
  double end = 0.0;
  for (const DrawnJoint& drawn : joints) {
    end = std::max(end, 1.1 * drawn.joint.density().largest_slip_force());
  }
  Figure figure;
  for (const DrawnJoint& drawn : joints) {
    Curve curve = slipped_share(drawn.joint, end);
    figure.layers.emplace_back(
        LineLayer{std::move(curve.x), std::move(curve.y), drawn.name, drawn.stroke});
  }
  figure.x.range = AxisRange{0.0, end};
  show_x(figure, "slip force f*", "N");
  show_y(figure, "share of k that slips up to f*", "1");
  return figure;
}

DensityCurve density_curve_of(const IdentifiedJoint& found) {
  const double from = 0.9 * found.covered_from.value_or(0.0);
  const double to =
      found.covered_to.value_or(macroslip_amplitude(found.joint) * found.joint.stiffness());
  DensityCurve curve = density_curve(found.joint, from, to);
  curve.lower = found.band_lower;
  curve.upper = found.band_upper;
  curve.band_slip_force = found.band_slip_force;
  curve.confidence = found.band_confidence;
  curve.covered_from = found.covered_from;
  curve.covered_to = found.covered_to;
  curve.name = density_name(name_of(found), found.joint);
  curve.atom_slip_force = found.joint.density().atoms().slip_force;
  return curve;
}

}  // namespace

Figure paper_energies(const ExperimentResults& results, const PaperOptions& options) {
  const MeasuredLevels& test = levels_of(results);
  Figure figure;
  add_curves(figure, results, options, dissipation);
  add_with_damping(figure, results);
  if (!test.input_energy.empty()) {
    figure.layers.emplace_back(points_of(test, {test.input_energy, {}}, "input energy", kGrey));
  }
  if (!test.linear_dissipation.empty()) {
    figure.layers.emplace_back(
        points_of(test, {test.linear_dissipation, {}}, "linear loss", kOrange));
  }
  const bool damped = results.joint && results.joint->linear_damping;
  figure.layers.emplace_back(
      points_of(test, measured_dissipation(results), damped ? "D, with damping βA²" : "joint, D"));
  show_amplitude(figure, options, true);
  show_y(figure, "energy per cycle", "J");
  figure.y.log = figure.x.log;
  return figure;
}

Figure paper_density(const ExperimentResults& results, const PaperOptions& options) {
  const IdentifiedJoint& found = joint_of(results);
  if (is_of_atoms(found.joint.density())) return slipped_shares(drawn_joints(results, options));
  return density_figure("", density_curve_of(found), drawn_others(results, options));
}

Figure paper_density(const DensityCurve& curve, const PaperOptions& options) {
  return density_figure("", curve, drawn_others({}, options));
}

Figure paper_loops(const ExperimentResults& results, const PaperOptions& options) {
  const IdentifiedJoint& found = joint_of(results);
  const std::vector<double> amplitudes = loop_amplitudes(largest_amplitude(results));
  const ShownUnit unit = shown_unit("m", amplitudes.front());
  Figure figure;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    figure.layers.emplace_back(
        loop_of(found.joint, amplitudes[i],
                fmt::format("A = {:.4g} {}", amplitudes[i] / unit.size, unit.text),
                {.colour = static_cast<int>(i)}));
  }
  for (DrawnJoint& drawn : drawn_others(results, options)) {
    drawn.stroke = {.colour = kBlack, .style = LineStyle::kDotted, .width = 1.2};
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      figure.layers.emplace_back(
          loop_of(drawn.joint, amplitudes[i], i == 0 ? drawn.name : "", drawn.stroke));
    }
  }
  show_x(figure, "joint displacement", "m");
  show_y(figure, "joint force", "N");
  return figure;
}

Figure paper_resonance(const ExperimentResults& results, const PaperOptions& options) {
  const MeasuredLevels& levels = levels_of(results);
  Figure figure;
  if (!levels.frequency.empty()) {
    const bool both = !levels.resonance_frequency.empty();
    figure.layers.emplace_back(
        frequencies_of(levels, levels.frequency, both ? "drive" : "", both ? kOrange : kBlack));
  }
  if (!levels.resonance_frequency.empty()) {
    figure.layers.emplace_back(
        frequencies_of(levels, levels.resonance_frequency, "resonance", kBlack));
  }
  if (figure.layers.empty()) {
    throw_missing("levels.frequency", "the figure needs frequencies of the levels");
  }
  if (levels.response_amplitude.empty()) {
    show_amplitude(figure, options, false);
  } else {
    show_x(figure, kResponseLabel, "m/s^2");
    figure.x.log = is_log(options, false);
  }
  show_y(figure, "frequency", "Hz");
  return figure;
}

Figure paper_stiffness(const ExperimentResults& results, const PaperOptions& options) {
  return over_amplitude(results, options, kSecant, measured_secant(results));
}

Figure paper_damping(const ExperimentResults& results, const PaperOptions& options) {
  const MeasuredPoints measured = measured_loss_factor(results);
  if (!results.joint && measured.value.empty() && !levels_of(results).damping_ratio.empty()) {
    return damping_ratios(*results.levels, options);
  }
  return over_amplitude(results, options, kLossFactor, measured);
}

FigureGrid paper_dissipation(const ExperimentResults& results, const PaperOptions& options) {
  (void)joint_of(results);
  FigureGrid grid{"",
                  3,
                  {over_amplitude(results, options, kDissipation, measured_dissipation(results)),
                   over_amplitude(results, options, kSecant, measured_secant(results)),
                   over_amplitude(results, options, kLossFactor, measured_loss_factor(results))}};
  for (std::size_t i = 1; i < grid.panels.size(); ++i) {
    grid.panels[i].legend = Legend::kNone;  // that of the first serves all
  }
  return grid;
}

Figure paper_constant_response(const ExperimentResults& results) {
  if (results.responses.empty()) {
    throw_missing("responses", "the figure needs responses of a rig with a joint");
  }
  Figure figure;
  const auto add = [&figure](double response, const std::vector<double>& frequency,
                             const std::vector<double>& force, std::string legend,
                             const Stroke& stroke) {
    LineLayer line{frequency, {}, std::move(legend), stroke};
    for (const double f : force) line.y.push_back(response / f);
    figure.layers.emplace_back(std::move(line));
  };
  for (std::size_t i = 0; i < results.responses.size(); ++i) {
    const ConstantResponse& response = results.responses[i];
    add(response.response, response.frequency, response.force,
        fmt::format("{:.3g} m/s²", response.response), {.colour = static_cast<int>(i)});
  }
  bool named = false;
  for (const ConstantResponse& response : results.responses) {
    if (response.true_frequency.empty()) continue;
    add(response.response, response.true_frequency, response.true_force, named ? "" : "truth",
        {.colour = kBlack, .style = LineStyle::kDotted, .width = 1.2});
    named = true;
  }
  show_x(figure, "frequency", "Hz");
  show_y(figure, "acceleration over force", "m/s²/N");
  figure.y.log = true;
  return figure;
}

FigureGrid paper_deviations(const ExperimentResults& results, const PaperOptions& options) {
  if (results.comparisons.empty()) throw_missing("comparisons", "the figure needs a verification");
  std::vector<std::string> channels;
  for (const ChannelMisfit& row : results.comparisons) {
    if (std::ranges::find(channels, row.channel) == channels.end()) channels.push_back(row.channel);
  }
  FigureGrid grid{"", 3, {}};
  for (const std::string& channel : channels) {
    PointLayer nrmse{.x = {}, .y = {}, .legend = "prediction", .colour = kBlack, .open = true};
    PointLayer noise{.x = {}, .y = {}, .legend = "noise alone", .colour = kOrange, .size = 0.6};
    for (const ChannelMisfit& row : results.comparisons) {
      if (row.channel != channel) continue;
      nrmse.x.push_back(row.response_amplitude);
      nrmse.y.push_back(row.nrmse);
      noise.y.push_back(row.noise_share);
    }
    const auto has_positive = [](const std::vector<double>& values) {
      return std::ranges::any_of(values, [](double value) { return value > 0.0; });
    };
    noise.x = nrmse.x;
    Figure panel;
    panel.layers = {noise, nrmse};
    panel.title = channel;
    show_x(panel, kResponseLabel, "m/s^2");
    show_y(panel, "rms error over rms", "%");
    panel.x.log = is_log(options, true) && has_positive(nrmse.x);
    panel.y.log = has_positive(nrmse.y) || has_positive(noise.y);
    grid.panels.push_back(std::move(panel));
  }
  return grid;
}

}  // namespace microslip
