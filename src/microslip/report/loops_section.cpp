// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

constexpr std::size_t kHalfLoop = 120;  // points

struct LoopJoint {
  std::string name;
  Joint joint;
  Stroke stroke;
};

ReportTrace loop_of(const LoopJoint& named, double amplitude) {
  SteadyLoop loop = steady_loop(named.joint, amplitude, kHalfLoop);
  return {.name = named.name,
          .kind = TraceKind::kLoop,
          .x = in_unit(std::move(loop.displacement), kMicrometre),
          .y = std::move(loop.force),
          .stroke = named.stroke};
}

/// Spline joints around the λ of cross-validation. [AR14 Fig. 10]
void add_splines(const MethodComparison& methods, std::vector<LoopJoint>& joints) {
  int colour = kGreen;
  for (const double factor : {0.01, 1.0, 100.0}) {
    const std::string name =
        factor == 1.0 ? "spline, λ by cross-validation" : fmt::format("spline, {:g} λ", factor);
    joints.push_back(
        {name, spline_with(methods, factor).joint, {.colour = colour++, .width = 1.3}});
  }
}

/// All joints but the first are compared with it.
struct ComparedLoops {
  std::vector<ReportChoice> loops;
  std::vector<ReportChoice> differences;
};

ComparedLoops compare(const std::vector<LoopJoint>& joints, double highest) {
  ComparedLoops all;
  for (const double share : {1.0, 0.75, 0.5, 0.25}) {
    const double amplitude = share * highest;
    const std::string name = fmt::format("{:.4g} µm", amplitude / kMicrometre);
    all.loops.push_back({name, {}});
    all.differences.push_back({name, {}});
    const ReportTrace base = loop_of(joints.front(), amplitude);
    all.loops.back().traces.push_back(base);
    for (std::size_t j = 1; j < joints.size(); ++j) {
      ReportTrace loop = loop_of(joints[j], amplitude);
      all.loops.back().traces.push_back(loop);
      for (std::size_t i = 0; i < base.y.size(); ++i) loop.y[i] -= base.y[i];
      all.differences.back().traces.push_back(std::move(loop));
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
