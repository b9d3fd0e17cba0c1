// SPDX-License-Identifier: MIT
#include "microslip/report/document/figure_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/report/document/shown_unit.hpp"

namespace microslip {
namespace {

constexpr std::array<Stroke, 3> kOthers = {{{.colour = kGreen, .style = LineStyle::kDashDotted},
                                            {.colour = kPurple, .style = LineStyle::kLongDashed},
                                            {.colour = kOrange, .style = LineStyle::kDotted}}};

/// Amplitudes at which curves beside the levels are sampled, m.
std::vector<double> drawn_amplitudes(const ExperimentResults& results) {
  if (results.levels) return curve_amplitudes(results.levels->levels);
  const IdentifiedJoint& found = joint_of(results);
  const double k = found.joint.stiffness();
  if (found.covered_from && found.covered_to && *found.covered_from > 0.0) {
    return equal_ratios(*found.covered_from / k, *found.covered_to / k);
  }
  const double end = macroslip_amplitude(found.joint);
  return equal_ratios(1e-3 * end, 2.0 * end);
}

}  // namespace

void throw_missing(const char* what, const char* rule) {
  throw InputError(what, InputState{"missing"}, rule);
}

const IdentifiedJoint& joint_of(const ExperimentResults& results) {
  if (!results.joint) throw_missing("joint", "the figure needs a joint");
  return *results.joint;
}

const MeasuredLevels& levels_of(const ExperimentResults& results) {
  if (!results.levels) throw_missing("levels", "the figure needs levels");
  return *results.levels;
}

const char* joint_name(const IdentifiedJoint& found) {
  return found.covered_to ? "identified joint" : "joint";
}

std::vector<ShownJoint> drawn_others(const ExperimentResults& results,
                                     const FigureOptions& options) {
  std::vector<ShownJoint> drawn;
  if (results.truth) drawn.push_back({"truth", *results.truth, kTruth});
  for (std::size_t i = 0; i < options.others.size(); ++i) {
    const NamedJoint& other = options.others[i];
    drawn.push_back({other.name, other.joint, kOthers.at(i % kOthers.size())});
  }
  return drawn;
}

std::vector<ShownJoint> drawn_joints(const ExperimentResults& results,
                                     const FigureOptions& options) {
  std::vector<ShownJoint> drawn;
  if (results.joint) drawn.push_back({joint_name(*results.joint), results.joint->joint, kFound});
  std::ranges::move(drawn_others(results, options), std::back_inserter(drawn));
  return drawn;
}

double macroslip_amplitude(const Joint& joint) {
  const double slip_force = joint.density().largest_slip_force();
  if (slip_force > 0.0) return slip_force / joint.stiffness();
  throw InputError("joint", "no slider", "the figure needs a joint of which a part slips");
}

bool is_log(const FigureOptions& options, bool suits) {
  return options.scale == AmplitudeScale::kAsSuits ? suits : options.scale == AmplitudeScale::kLog;
}

PointLayer at_levels(const MeasuredLevels& levels, const MeasuredPoints& measured,
                     std::string legend, int colour) {
  return {.x = levels.levels.amplitude,
          .y = measured.value,
          .y_error = measured.std,
          .legend = std::move(legend),
          .colour = colour,
          .open = true};
}

void add_curves(Figure& figure, const ExperimentResults& results, const FigureOptions& options,
                JointQuantity quantity) {
  const std::vector<double> amplitude = drawn_amplitudes(results);
  for (const ShownJoint& drawn : drawn_joints(results, options)) {
    figure.layers.emplace_back(LineLayer{amplitude, joint_curve(drawn.joint, quantity, amplitude),
                                         drawn.name, drawn.stroke});
  }
}

void add_with_damping(Figure& figure, const ExperimentResults& results) {
  if (!results.joint || !results.joint->linear_damping) return;
  const IdentifiedJoint& found = *results.joint;
  const std::vector<double> amplitude = drawn_amplitudes(results);
  figure.layers.emplace_back(
      LineLayer{amplitude,
                joint_curve(found.joint, dissipation, amplitude, *found.linear_damping),
                "with damping βA²",
                {.colour = kGreen, .style = LineStyle::kLongDashed}});
}

void show_amplitude(Figure& figure, const FigureOptions& options, bool suits_log) {
  show_x(figure, "joint amplitude A", "m");
  figure.x.log = is_log(options, suits_log);
  figure.x.log_switch = true;
}

void show_response(Figure& figure, const FigureOptions& options, bool suits_log) {
  const std::string& unit = options.response_unit;
  show_x(figure, "exciter acceleration", {unit, parse_unit(unit, kAcceleration).factor()});
  figure.x.log = is_log(options, suits_log);
  figure.x.log_switch = true;
}

}  // namespace microslip
