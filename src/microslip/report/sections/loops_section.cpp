// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "microslip/report/document/shown_unit.hpp"
#include "microslip/report/figures/compared_loops.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

ReportFigure figure_of(std::string title, std::string caption, const char* force,
                       std::vector<FigureChoice> loops) {
  ReportFigure figure{
      .figure = {.title = std::move(title), .caption = std::move(caption)},
      .choose = "Amplitude",
      .choices = std::move(loops),
  };
  show_x(figure, kLoopDisplacement, "m");
  show_y(figure, force, "N");
  return figure;
}

}  // namespace

ReportSection loops_section(const ExperimentResults& results,
                            const std::optional<MethodComparison>& methods) {
  ReportSection section{.title = "Loops", .blocks = {}};
  if (!results.joint) return section;
  if (!results.levels) {
    section.blocks.emplace_back(
        ReportMissing{"No loops, which need an amplitude: no levels.csv in this folder.", ""});
    return section;
  }
  const std::vector<ShownJoint> joints = joints_to_compare(results, methods);
  std::vector<FigureChoice> loops;
  std::vector<FigureChoice> differences;
  for (const double amplitude :
       loop_amplitudes(std::ranges::max(results.levels->levels.amplitude))) {
    ComparedLoops compared = compared_loops(joints, amplitude);
    const std::string name = fmt::format("{:.4g} µm", amplitude / kMicrometre);
    loops.push_back({name, std::move(compared.loops)});
    differences.push_back({name, std::move(compared.differences)});
  }
  section.blocks.emplace_back(
      figure_of("Regenerated loops",
                methods ? "With the smoothing of the spline a hundred times weaker and stronger: "
                          "where the loops coincide, they do not depend on it. [AR14 Fig. 10]"
                        : "Steady loops of one amplitude.",
                kLoopForce, std::move(loops)));
  if (joints.size() > 1) {
    section.blocks.emplace_back(figure_of("Difference to the identified joint",
                                          "Force of each loop less that of the identified joint.",
                                          "force difference", std::move(differences)));
  }
  return section;
}

}  // namespace microslip
