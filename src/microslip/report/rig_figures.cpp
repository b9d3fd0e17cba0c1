// SPDX-License-Identifier: MIT
#include "microslip/report/rig_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/report/harmonic_bars.hpp"
#include "microslip/report/scales.hpp"
#include "microslip/workflow/level_records.hpp"

namespace microslip {
namespace {

constexpr double kMostDistortion = 0.01;  // of the force [AR14]
constexpr int kBefore = kVermillion;
constexpr int kAfter = kBlue;

constexpr const char* kAmplitudeLabel = "joint amplitude A [µm]";

FigureAxis response_axis(const std::string& unit) {
  return {.label = fmt::format("acceleration amplitude at the exciter [{}]", unit)};
}

double size_of(const std::string& unit) { return parse_unit(unit, kAcceleration).factor(); }

LineLayer force_history(const DrivenVibration& driven, const char* name, int colour) {
  Curve curve = force_over_cycle(driven, 400);
  return {in_unit(std::move(curve.x), kMillisecond), std::move(curve.y), name, {.colour = colour}};
}

/// The first harmonic, and the others over it, %.
std::vector<double> heights_of(const std::vector<double>& shares) {
  std::vector<double> heights = {1.0 / kPercent};
  for (const double share : shares) heights.push_back(share / kPercent);
  return heights;
}

LineLayer asked_for(double from, double to) {
  return {{from, to},
          {kMostDistortion / kPercent, kMostDistortion / kPercent},
          "1 %, asked for",
          {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2}};
}

Figure force_histories(LineLayer before, LineLayer after) {
  Figure figure;
  figure.title = "Force at the highest level";
  figure.x = {.label = "time [ms]"};
  figure.y = {.label = "force [N]"};
  figure.layers = {std::move(before), std::move(after)};
  return figure;
}

Figure force_harmonics(const ForceControlLevel& level, const std::string& unit) {
  Figure figure;
  figure.title = "Its harmonics";
  figure.x = harmonic_axis(level.before.size() + 1);
  figure.x.label += fmt::format(", at {:.3g} {}", level.response, unit);
  figure.y = {.label = "harmonic over the first [%]", .log = true, .range = AxisRange{1e-3, 200.0}};
  add_harmonic_bars(figure, heights_of(level.before), BarSide::kLeft, kBefore, "before control");
  add_harmonic_bars(figure, heights_of(level.after), BarSide::kRight, kAfter, "after");
  figure.layers.emplace_back(asked_for(figure.x.range->from, figure.x.range->to));
  return figure;
}

Figure force_distortions(std::span<const ForceControlLevel> levels, const std::string& unit) {
  LineLayer before{{}, {}, "before control", {.colour = kBefore}};
  LineLayer after{{}, {}, "after", {.colour = kAfter}};
  const auto largest = [](const std::vector<double>& shares) {
    return shares.empty() ? 0.0 : std::ranges::max(shares) / kPercent;
  };
  for (const ForceControlLevel& level : levels) {
    for (auto* line : {&before, &after}) line->x.push_back(level.response / size_of(unit));
    before.y.push_back(largest(level.before));
    after.y.push_back(largest(level.after));
  }
  Figure figure;
  figure.title = "Largest harmonic, from the second";
  figure.x = response_axis(unit);
  figure.y = {.label = "harmonic over the first [%]", .log = true};
  figure.layers = {asked_for(before.x.front(), before.x.back()), before, after};
  return figure;
}

LineLayer curve_of(const ResponseCurve& curve, std::string name, Stroke stroke) {
  LineLayer line{{}, {}, std::move(name), stroke};
  for (const SteadyVibration& point : curve.points) {
    line.x.push_back(point.frequency());
    line.y.push_back(point.response / point.force_amplitude);
  }
  return line;
}

}  // namespace

Figure resonance_figure(const std::string& title, std::span<const ReducedLevel> levels,
                        const std::string& unit) {
  PointLayer drive{.x = {}, .y = {}, .legend = "drive", .colour = kGrey, .size = 0.6};
  LineLayer resonance{{}, {}, "resonance, by the measured phase", {.colour = kBlue}};
  for (const ReducedLevel& level : levels) {
    drive.x.push_back(level.response_amplitude / size_of(unit));
    drive.y.push_back(level.frequency);
    resonance.y.push_back(level.resonance_frequency);
  }
  resonance.x = drive.x;
  Figure figure;
  figure.title = title;
  figure.x = response_axis(unit);
  figure.y = {.label = "frequency [Hz]"};
  figure.layers = {drive, resonance};
  return figure;
}

Figure energies_figure(const std::string& title, std::span<const ReducedLevel> levels,
                       const Joint* truth) {
  LineLayer input{{}, {}, "input", {.colour = kBlack}};
  LineLayer linear{{}, {}, "linear loss", {.colour = kOrange, .style = LineStyle::kDashed}};
  LineLayer expected{{}, {}, "true joint", {.colour = kVermillion}};
  PointLayer joint{
      .x = {}, .y = {}, .legend = "joint: input less linear loss", .colour = kBlue, .size = 0.6};
  for (const ReducedLevel& level : levels) {
    if (!(level.dissipation.value > 0.0)) continue;
    input.x.push_back(level.amplitude.value / kMicrometre);
    input.y.push_back(level.input_energy.value / kMillijoule);
    linear.y.push_back(level.linear_dissipation / kMillijoule);
    joint.y.push_back(level.dissipation.value / kMillijoule);
    if (truth) expected.y.push_back(dissipation(*truth, level.amplitude.value) / kMillijoule);
  }
  linear.x = joint.x = expected.x = input.x;
  Figure figure;
  figure.title = title;
  figure.x = {.label = kAmplitudeLabel, .log = true};
  figure.y = {.label = "energy per cycle [mJ]", .log = true};
  figure.layers = {input, linear};
  if (truth) figure.layers.emplace_back(expected);
  figure.layers.emplace_back(joint);
  return figure;
}

Figure linear_share_figure(const std::string& title, std::span<const ReducedLevel> levels) {
  LineLayer share{{}, {}, "measured", {.colour = kOrange}};
  for (const ReducedLevel& level : levels) {
    share.x.push_back(level.amplitude.value / kMicrometre);
    share.y.push_back(level.linear_dissipation / level.input_energy.value / kPercent);
  }
  Figure figure;
  figure.title = title;
  figure.x = {.label = kAmplitudeLabel};
  figure.y = {.label = "linear loss over input [%]", .range = AxisRange{0.0, 100.0}};
  figure.layers = {share};
  return figure;
}

FigureGrid force_control_figure(const std::string& title, std::span<const VirtualLevel> levels,
                                std::size_t harmonics, const std::string& unit) {
  const std::vector<ForceControlLevel> controls = force_controls(levels, harmonics);
  const VirtualLevel& highest = levels.back();
  return {title,
          3,
          {force_histories(force_history(highest.uncontrolled, "before control", kBefore),
                           force_history(highest.controlled, "after", kAfter)),
           force_harmonics(controls.back(), unit), force_distortions(controls, unit)}};
}

FigureGrid force_control_figure(const std::string& title, std::span<const ForceControlLevel> levels,
                                const std::string& unit) {
  if (levels.empty()) throw InputError("levels.size()", 0, "the figure needs a force control");
  std::vector<ForceControlLevel> sorted(levels.begin(), levels.end());
  std::ranges::stable_sort(sorted, {}, &ForceControlLevel::response);
  return {title, 2, {force_harmonics(sorted.back(), unit), force_distortions(sorted, unit)}};
}

Figure constant_response_figure(const std::string& title, std::span<const NamedResponse> responses,
                                const std::string& unit) {
  Figure figure;
  figure.title = title;
  figure.x = {.label = "frequency [Hz]"};
  figure.y = {.label = "response over force [" + unit + "]", .log = true};
  int colour = kBlue;
  for (const NamedResponse& response : responses) {
    figure.layers.emplace_back(curve_of(response.predicted, response.name, {.colour = colour}));
    if (!response.expected.points.empty()) {
      figure.layers.emplace_back(curve_of(
          response.expected, "", {.colour = kBlack, .style = LineStyle::kDotted, .width = 1.4}));
    }
    ++colour;
  }
  return figure;
}

}  // namespace microslip
