// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/sections.hpp"
#include "microslip/workflow/other_methods.hpp"

namespace microslip {
namespace {

constexpr std::size_t kHalfLoop = 120;  // points

struct LoopJoint {
  std::string name;
  Joint joint;
  Stroke stroke;
};

/// Spline joints around the λ of cross-validation. [AR14 Fig. 10]
void add_splines(const MethodComparison& methods, std::vector<LoopJoint>& joints) {
  int colour = kGreen;
  for (auto& [factor, found] : varied_splines(methods)) {
    const std::string name =
        factor == 1.0 ? "spline, λ by cross-validation" : fmt::format("spline, {:g} λ", factor);
    joints.push_back({name, std::move(found.joint), {.colour = colour++, .width = 1.3}});
  }
}

/// All joints but the first are compared with it.
struct ComparedLoops {
  std::vector<ReportChoice> loops;
  std::vector<ReportChoice> differences;
};

ComparedLoops compare(const std::vector<LoopJoint>& joints, double highest) {
  ComparedLoops all;
  for (const double amplitude : loop_amplitudes(highest)) {
    const std::string name = fmt::format("{:.4g} µm", amplitude / kMicrometre);
    all.loops.push_back({name, {}});
    all.differences.push_back({name, {}});
    const SteadyLoop base = steady_loop(joints.front().joint, amplitude, kHalfLoop);
    const auto add = [&](ReportChoice& choice, const LoopJoint& named, std::vector<double> force) {
      choice.traces.push_back({.name = named.name,
                               .kind = TraceKind::kLoop,
                               .x = in_unit(base.displacement, kMicrometre),
                               .y = std::move(force),
                               .stroke = named.stroke});
    };
    add(all.loops.back(), joints.front(), base.force);
    for (const LoopJoint& named : joints | std::views::drop(1)) {
      const SteadyLoop loop = steady_loop(named.joint, amplitude, kHalfLoop);
      add(all.loops.back(), named, loop.force);
      add(all.differences.back(), named, force_difference(loop, base));
    }
  }
  return all;
}

ReportFigure figure_of(std::string title, std::string caption, std::string force,
                       std::vector<ReportChoice> loops) {
  return {.title = std::move(title),
          .caption = std::move(caption),
          .x = {.label = "displacement", .unit = "µm"},
          .y = {.label = std::move(force), .unit = "N"},
          .choose = "Amplitude",
          .choices = std::move(loops)};
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
  std::vector<LoopJoint> joints = {{kFoundName, results.joint->joint, kFound}};
  if (methods) add_splines(*methods, joints);
  if (results.truth) joints.push_back({"truth", *results.truth, kTruth});
  ComparedLoops all = compare(joints, std::ranges::max(results.levels->levels.amplitude));
  section.blocks.emplace_back(
      figure_of("Regenerated loops",
                methods ? "With the smoothing of the spline a hundred times weaker and stronger: "
                          "where the loops coincide, they do not depend on it. [AR14 Fig. 10]"
                        : "Steady loops of one amplitude.",
                "force", std::move(all.loops)));
  if (joints.size() > 1) {
    section.blocks.emplace_back(figure_of("Difference to the identified joint",
                                          "Force of each loop less that of the identified joint.",
                                          "force difference", std::move(all.differences)));
  }
  return section;
}

}  // namespace microslip
