// SPDX-License-Identifier: MIT
#include "microslip/report/figures/loops_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/compared_loops.hpp"
#include "microslip/workflow/results/other_methods.hpp"

namespace microslip {
namespace {

/// Largest amplitude of the loops that are drawn, m.
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

}  // namespace

Figure loops_figure(const ExperimentResults& results, const FigureOptions& options) {
  const IdentifiedJoint& found = joint_of(results);
  const std::vector<double> amplitudes = loop_amplitudes(largest_amplitude(results));
  const ShownUnit unit = shown_unit("m", amplitudes.front());
  Figure figure{.title = "Hysteresis loops", .caption = "Steady loops of the joint."};
  int colour = kBlue;
  for (const double amplitude : amplitudes) {
    figure.layers.emplace_back(loop_of(
        found.joint, amplitude, fmt::format("A = {:.4g} {}", amplitude / unit.size, unit.text),
        {.colour = colour++}));
  }
  for (const ShownJoint& drawn : drawn_others(results, options)) {
    for (const double amplitude : amplitudes) {
      figure.layers.emplace_back(
          loop_of(drawn.joint, amplitude, drawn.name,
                  {.colour = kBlack, .style = LineStyle::kDotted, .width = 1.2}));
    }
  }
  show_x(figure, kLoopDisplacement, "m");
  show_y(figure, kLoopForce, "N");
  return figure;
}

FigureGrid regenerated_loops_figure(const ExperimentResults& results) {
  (void)joint_of(results);
  const double highest = std::ranges::max(levels_of(results).levels.amplitude);
  ComparedLoops compared =
      compared_loops(joints_to_compare(results, compare_methods(results)), highest);
  Figure loops{.title = "Regenerated loops", .layers = std::move(compared.loops)};
  Figure differences{.title = "Difference to the identified joint",
                     .layers = std::move(compared.differences)};
  show_y(loops, kLoopForce, "N");
  show_y(differences, "force difference", "N");
  for (Figure* panel : {&loops, &differences}) show_x(*panel, kLoopDisplacement, "m");
  if (differences.layers.empty()) return {"", 1, {std::move(loops)}};
  return {"", 2, {std::move(loops), std::move(differences)}};
}

}  // namespace microslip
