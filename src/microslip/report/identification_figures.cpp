// SPDX-License-Identifier: MIT
#include "microslip/report/identification_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "microslip/base/percent.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/report/scales.hpp"
#include "microslip/report/shown_unit.hpp"
#include "microslip/workflow/sampled_curves.hpp"

namespace microslip {
namespace {

constexpr std::size_t kCurvePoints = 200;

/// What belongs to the slip forces that the levels cover.
std::vector<double> covered(const DensityCurve& curve, const std::vector<double>& slip_force,
                            const std::vector<double>& values) {
  std::vector<double> kept;
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (slip_force[j] >= 0.9 * curve.covered_from.value_or(0.0)) kept.push_back(values[j]);
  }
  return kept;
}

LineLayer density_line(const Joint& joint, double from, double to, std::string name,
                       const Stroke& stroke) {
  DensityPoints points = density_points(joint, from, to);
  return {std::move(points.slip_force), std::move(points.density), std::move(name), stroke};
}

/// The highest that a line or band of the figure reaches.
double highest_of(const Figure& figure) {
  double highest = 0.0;
  for (const Layer& layer : figure.layers) {
    const std::vector<double>* values = nullptr;
    if (const auto* line = std::get_if<LineLayer>(&layer)) values = &line->y;
    if (const auto* band = std::get_if<BandLayer>(&layer)) values = &band->upper;
    if (values != nullptr && !values->empty()) {
      highest = std::max(highest, std::ranges::max(*values));
    }
  }
  return highest;
}

void add_marker(Figure& figure, const std::optional<double>& at, const char* label) {
  if (at) figure.layers.emplace_back(MarkerLayer{.x = *at, .label = label});
}

}  // namespace

Figure dissipation_figure(const std::string& title, const Levels& levels,
                          const Identification& found) {
  Figure figure;
  figure.title = title;
  figure.x = {.label = "amplitude A [µm]", .log = true};
  figure.y = {.label = "dissipation per cycle D [mJ]", .log = true};
  const auto [lowest, highest] = std::ranges::minmax(levels.amplitude);
  const std::vector<double> amplitude = equal_ratios(lowest, highest, kCurvePoints);
  const double beta = found.linear_damping.value_or(0.0);
  const std::vector<double> x = in_unit(amplitude, kMicrometre);
  if (beta > 0.0) {
    figure.layers.emplace_back(
        LineLayer{x,
                  in_unit(joint_curve(found.joint, dissipation, amplitude), kMillijoule),
                  "joint",
                  {.colour = kGreen, .style = LineStyle::kDashed}});
    figure.layers.emplace_back(LineLayer{x,
                                         in_unit(damping_curve(amplitude, beta), kMillijoule),
                                         "linear damping βA²",
                                         {.colour = kOrange, .style = LineStyle::kDotted}});
  }
  figure.layers.emplace_back(
      LineLayer{x,
                in_unit(joint_curve(found.joint, dissipation, amplitude, beta), kMillijoule),
                "identified",
                {.colour = kBlue}});
  figure.layers.emplace_back(PointLayer{.x = in_unit(levels.amplitude, kMicrometre),
                                        .y = in_unit(levels.dissipation, kMillijoule),
                                        .legend = "measured",
                                        .colour = kBlack,
                                        .size = 0.7});
  return figure;
}

Figure density_figure(const std::string& title, const DensityCurve& curve,
                      std::span<const DrawnJoint> joints) {
  Figure figure;
  figure.title = title;
  const double end = curve.covered_to.value_or(curve.slip_force.back());
  if (!curve.lower.empty()) {
    const std::vector<double>& f =
        curve.band_slip_force.empty() ? curve.slip_force : curve.band_slip_force;
    figure.layers.emplace_back(BandLayer{
        covered(curve, f, f), covered(curve, f, curve.lower), covered(curve, f, curve.upper),
        fmt::format("{:.0f} % band", 100.0 * curve.confidence), kBlue});
  }
  figure.layers.emplace_back(LineLayer{covered(curve, curve.slip_force, curve.slip_force),
                                       covered(curve, curve.slip_force, curve.density),
                                       curve.name,
                                       {.colour = kBlue}});
  for (const DrawnJoint& drawn : joints) {
    figure.layers.emplace_back(
        density_line(drawn.joint, 0.0, end, density_name(drawn.name, drawn.joint), drawn.stroke));
  }
  add_marker(figure, curve.covered_from, "kA of lowest level");
  add_marker(figure, curve.covered_to, "kA of highest level");
  for (std::size_t i = 0; i < curve.atom_slip_force.size() && i < kMostAtomsShown; ++i) {
    add_marker(figure, curve.atom_slip_force[i], "atom");
  }
  figure.x.range = AxisRange{0.0, 1.05 * end};
  if (const double highest = highest_of(figure); highest > 0.0) {
    figure.y.range = AxisRange{0.0, 1.05 * highest};
  }
  show_x(figure, "slip force f*", "N");
  show_y(figure, "density φ", "1/N");
  return figure;
}

std::string density_name(const std::string& name, const Joint& joint) {
  double share = 0.0;
  for (const double weight : joint.density().atoms().weight) share += weight;
  if (share == 0.0) return name;
  return fmt::format("{} without its atoms, {} of k", name, percent_text(share));
}

DensityCurve density_curve(const Joint& joint, double from, double to) {
  LineLayer line = density_line(joint, from, to, "", {});
  return {.slip_force = std::move(line.x), .density = std::move(line.y)};
}

Figure density_figure(const std::string& title, const Identification& found, const Joint* truth) {
  const DensityCurve curve{.slip_force = found.slip_force,
                           .density = found.density,
                           .lower = found.lower,
                           .upper = found.upper,
                           .covered_from = found.covered_from,
                           .covered_to = found.covered_to};
  if (truth == nullptr) return density_figure(title, curve, {});
  const DrawnJoint drawn{"truth", *truth, {.colour = kVermillion, .style = LineStyle::kDashed}};
  return density_figure(title, curve, {{drawn}});
}

FigureGrid loops_figure(const std::string& title, double amplitude, const NamedJoint& reference,
                        const std::vector<NamedJoint>& joints) {
  Figure loops;
  loops.title = "Regenerated loops";
  loops.x = {.label = "displacement [µm]"};
  loops.y = {.label = "force [N]"};
  Figure difference;
  difference.title = "Difference to " + reference.name;
  difference.x = loops.x;
  difference.y = {.label = "force difference [N]"};

  const SteadyLoop base = steady_loop(reference.joint, amplitude, kCurvePoints);
  const std::vector<double> x = in_unit(base.displacement, kMicrometre);
  loops.layers.emplace_back(
      LoopLayer{x, base.force, reference.name, {.colour = kBlack, .width = 2.6}});
  int colour = kBlue;
  for (const NamedJoint& named : joints) {
    const SteadyLoop loop = steady_loop(named.joint, amplitude, kCurvePoints);
    loops.layers.emplace_back(
        LoopLayer{x, loop.force, named.name, {.colour = colour, .width = 1.4}});
    difference.layers.emplace_back(
        LoopLayer{x, force_difference(loop, base), named.name, {.colour = colour, .width = 1.4}});
    ++colour;
  }
  return {title, 2, {loops, difference}};
}

}  // namespace microslip
