// SPDX-License-Identifier: MIT
// Fig. 2: loops of the Iwan joint for rising amplitude on the virgin curve. [AR14 (2) (3)]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves.hpp"
#include "figures.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/jenkins_network.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::Joint;

constexpr double kAmplitudes[] = {50e-6, 150e-6, 250e-6, 350e-6, 500e-6};  // m

/// The joint as sliders that are marched one by one: nothing in it knows Masing's rule.
std::vector<double> by_sliders(const Joint& joint, const std::vector<double>& x,
                               std::size_t sliders) {
  const auto network = microslip::JenkinsNetwork::discretise(joint, sliders);
  microslip::NetworkMemory memory(network);
  memory.advance(x.front());
  std::vector<double> force(x.size());
  memory.march(x, force);
  return force;
}

/// ∮ f dx by the trapezoidal rule.
double area(const Loop& loop) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.force.size(); ++i) {
    const std::size_t next = (i + 1) % loop.force.size();
    sum +=
        0.5 * (loop.force[i] + loop.force[next]) * (loop.displacement[next] - loop.displacement[i]);
  }
  return sum;
}

microslip::Figure empty_figure() {
  microslip::Figure figure;
  figure.title = "Loops of an Iwan joint";
  figure.subtitle =
      "steady cycles of rising amplitude, and the virgin curve on which their tips lie";
  figure.x = {.label = "displacement x", .unit = "µm"};
  figure.y = {.label = "force f", .unit = "N"};
  figure.legend = microslip::Legend::kRight;
  return figure;
}

/// By how much loops differ from the closed forms, relative.
struct Deviations {
  double from_masing = 0.0;  // of the force, over that at the tip
  double from_area = 0.0;    // of the area, from (7)
};

void include(Deviations& largest, const Joint& joint, const Loop& loop, std::size_t sliders) {
  const double amplitude = loop.displacement.front();
  const double tip = joint.virgin_force(amplitude);
  const auto virgin = [&](double x) { return joint.virgin_force(x); };
  const std::vector<double> masing = masing_loop(virgin, loop.displacement);
  const std::vector<double> sliding = by_sliders(joint, loop.displacement, sliders);
  for (const auto& force : {sliding, loop.force}) {
    largest.from_masing = std::max(largest.from_masing, largest_difference(force, masing) / tip);
  }
  const double expected = microslip::dissipation(joint, amplitude);
  largest.from_area = std::max(largest.from_area, std::abs(area(loop) / expected - 1.0));
}

std::vector<Finding> findings_of(const Grid& grid, const Joint& joint, const Deviations& largest) {
  const double beyond = 1.02 * joint.macroslip_displacement();
  return {
      // Two sliders a bin of equal weight: exact at the edges of the bins, and off by the square of
      // their width between them.
      {"loops marched with single sliders against (3), largest difference over the force at the "
       "tip "
       "[1]",
       "(3), Masing's rule", largest.from_masing, 0.0, grid.pick(1e-5, 1e-4)},
      // Trapezoidal rule on a closed smooth-sided loop: of the order 1/points².
      {"area of the loops against (7), largest relative difference [1]", "(7)", largest.from_area,
       0.0, grid.pick(1e-4, 1e-3)},
      {fmt::format("force at {:.0f} µm, all slipping, over f_y [1]", beyond / kMicrometre),
       "(1), the ultimate force", joint.virgin_force(beyond) / joint.macroslip_force(), 1.0 - 1e-12,
       1.0 + 1e-12}};
}

}  // namespace

Reproduction figure_02(const Grid& grid, const Joint& joint) {
  const auto points = grid.pick<std::size_t>(2000, 400);
  microslip::Figure figure = empty_figure();
  CurveTable table({{"displacement", microslip::kLength}, {"force", microslip::kForce}});
  Deviations largest;
  int colour = microslip::kBlue;
  for (const double amplitude : kAmplitudes) {
    const Loop loop = steady_loop(joint, amplitude, points);
    include(largest, joint, loop, grid.pick<std::size_t>(2000, 400));
    const std::string name = fmt::format("A = {:.0f} µm", amplitude / kMicrometre);
    table.add(name, {loop.displacement, loop.force});
    figure.layers.emplace_back(microslip::LoopLayer{
        scaled(loop.displacement, kMicrometre), loop.force, name, {.colour = colour++}});
  }
  const std::vector<double> x = equal_steps(0.0, std::ranges::max(kAmplitudes), points / 2);
  std::vector<double> virgin(x.size());
  std::ranges::transform(x, virgin.begin(), [&](double at) { return joint.virgin_force(at); });
  table.add("virgin curve", {x, virgin});
  figure.layers.emplace_back(microslip::LineLayer{
      scaled(x, kMicrometre),
      virgin,
      "virgin curve (2)",
      {.colour = microslip::kBlack, .style = microslip::LineStyle::kDashed, .width = 1.4}});

  Reproduction made{.name = "fig_02", .title = "Loops of the Iwan joint", .picture = figure};
  made.size = {.width = 860, .height = 500};
  made.tables.emplace_back("", table.table());
  made.findings = findings_of(grid, joint, largest);
  return made;
}

}  // namespace ahmadian_rajaei
