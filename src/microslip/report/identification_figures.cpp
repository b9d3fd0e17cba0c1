// SPDX-License-Identifier: MIT
#include "microslip/report/identification_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip {
namespace {

constexpr double kMicrometre = 1e-6;
constexpr double kMillijoule = 1e-3;
constexpr double kPerKilonewton = 1e-3;
constexpr std::size_t kCurvePoints = 200;

std::vector<double> scaled(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

std::vector<double> equal_ratios(double from, double to) {
  std::vector<double> values;
  for (std::size_t i = 0; i < kCurvePoints; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kCurvePoints - 1);
    values.push_back(from * std::pow(to / from, share));
  }
  return values;
}

/// What belongs to the slip forces that the levels cover: below them the shape is an assumption.
std::vector<double> covered(const Identification& found, const std::vector<double>& values) {
  std::vector<double> kept;
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (found.slip_force[j] >= 0.9 * found.covered_from) kept.push_back(values[j]);
  }
  return kept;
}

/// The steady loop from A down and up again.
struct Loop {
  std::vector<double> displacement;  // m
  std::vector<double> force;         // N
};

Loop steady_loop(const Joint& joint, double amplitude) {
  Loop loop;
  Memory memory(joint);
  memory.advance(amplitude);
  const auto half = static_cast<double>(kCurvePoints);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < kCurvePoints; ++i) {
      const double x = sign * amplitude * (1.0 - 2.0 * static_cast<double>(i) / half);
      loop.displacement.push_back(x);
      loop.force.push_back(memory.advance(x));
    }
  }
  return loop;
}

}  // namespace

Figure dissipation_figure(const std::string& title, const Levels& levels,
                          const Identification& found) {
  Figure figure;
  figure.title = title;
  figure.x = {.label = "amplitude A [µm]", .log = true};
  figure.y = {.label = "dissipation per cycle D [mJ]", .log = true};
  const auto [lowest, highest] = std::ranges::minmax(levels.amplitude);
  const std::vector<double> amplitude = equal_ratios(lowest, highest);
  const double beta = found.linear_damping.value_or(0.0);
  std::vector<double> total;
  std::vector<double> joint_only;
  std::vector<double> damping;
  for (const double a : amplitude) {
    joint_only.push_back(dissipation(found.joint, a));
    damping.push_back(beta * a * a);
    total.push_back(joint_only.back() + damping.back());
  }
  const std::vector<double> x = scaled(amplitude, kMicrometre);
  if (beta > 0.0) {
    figure.layers.emplace_back(LineLayer{x,
                                         scaled(joint_only, kMillijoule),
                                         "joint",
                                         {.colour = kGreen, .style = LineStyle::kDashed}});
    figure.layers.emplace_back(LineLayer{x,
                                         scaled(damping, kMillijoule),
                                         "linear damping βA²",
                                         {.colour = kOrange, .style = LineStyle::kDotted}});
  }
  figure.layers.emplace_back(
      LineLayer{x, scaled(total, kMillijoule), "identified", {.colour = kBlue}});
  figure.layers.emplace_back(PointLayer{.x = scaled(levels.amplitude, kMicrometre),
                                        .y = scaled(levels.dissipation, kMillijoule),
                                        .legend = "measured",
                                        .colour = kBlack,
                                        .size = 0.7});
  return figure;
}

Figure density_figure(const std::string& title, const Identification& found, const Joint* truth) {
  Figure figure;
  figure.title = title;
  figure.x = {.label = "slip force f* [N]", .range = AxisRange{0.0, 1.05 * found.covered_to}};
  figure.y = {.label = "density φ [1/kN]"};
  const std::vector<double> x = covered(found, found.slip_force);
  const auto drawn = [&](const std::vector<double>& values) {
    return scaled(covered(found, values), kPerKilonewton);
  };
  double highest = std::ranges::max(drawn(found.density));
  if (!found.lower.empty()) {
    highest = std::max(highest, std::ranges::max(drawn(found.upper)));
    figure.layers.emplace_back(
        BandLayer{x, drawn(found.lower), drawn(found.upper), "95 % band", kBlue});
  }
  figure.y.range = AxisRange{0.0, 1.05 * highest};
  figure.layers.emplace_back(LineLayer{x, drawn(found.density), "identified", {.colour = kBlue}});
  if (truth != nullptr) {
    std::vector<double> f;
    std::vector<double> density;
    for (std::size_t i = 0; i <= kCurvePoints; ++i) {
      f.push_back(found.covered_to * static_cast<double>(i) / static_cast<double>(kCurvePoints));
      density.push_back(truth->density().density(f.back()) / kPerKilonewton);
    }
    figure.layers.emplace_back(
        LineLayer{f, density, "truth", {.colour = kVermillion, .style = LineStyle::kDashed}});
  }
  figure.layers.emplace_back(MarkerLayer{.x = found.covered_from, .label = "kA of lowest level"});
  figure.layers.emplace_back(MarkerLayer{.x = found.covered_to, .label = "kA of highest level"});
  return figure;
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

  const Loop base = steady_loop(reference.joint, amplitude);
  const std::vector<double> x = scaled(base.displacement, kMicrometre);
  loops.layers.emplace_back(
      LoopLayer{x, base.force, reference.name, {.colour = kBlack, .width = 2.6}});
  int colour = kBlue;
  for (const NamedJoint& named : joints) {
    const Loop loop = steady_loop(named.joint, amplitude);
    std::vector<double> apart(loop.force.size());
    std::ranges::transform(loop.force, base.force, apart.begin(),
                           [](double a, double b) { return a - b; });
    loops.layers.emplace_back(
        LoopLayer{x, loop.force, named.name, {.colour = colour, .width = 1.4}});
    difference.layers.emplace_back(
        LoopLayer{x, apart, named.name, {.colour = colour, .width = 1.4}});
    ++colour;
  }
  return {title, 2, {loops, difference}};
}

}  // namespace microslip
