// SPDX-License-Identifier: MIT
#include "microslip/report/figures/compared_loops.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "microslip/workflow/results/other_methods.hpp"

namespace microslip {

ComparedLoops compared_loops(std::span<const ShownJoint> joints, double amplitude) {
  constexpr std::size_t kHalfLoop = 120;  // points
  ComparedLoops compared;
  const SteadyLoop base = steady_loop(joints.front().joint, amplitude, kHalfLoop);
  const auto add = [&](std::vector<Layer>& layers, const ShownJoint& drawn,
                       std::vector<double> force) {
    layers.emplace_back(LoopLayer{base.displacement, std::move(force), drawn.name, drawn.stroke});
  };
  add(compared.loops, joints.front(), base.force);
  for (const ShownJoint& drawn : joints.subspan(1)) {
    const SteadyLoop loop = steady_loop(drawn.joint, amplitude, kHalfLoop);
    add(compared.loops, drawn, loop.force);
    add(compared.differences, drawn, force_difference(loop, base));
  }
  return compared;
}

std::vector<ShownJoint> joints_to_compare(const ExperimentResults& results,
                                          const std::optional<MethodComparison>& methods) {
  std::vector<ShownJoint> joints = drawn_joints(results, {});
  if (!methods) return joints;
  std::vector<ShownJoint> splines;
  int colour = kGreen;
  for (auto& [factor, found] : varied_splines(*methods)) {
    const std::string name =
        factor == 1.0 ? "spline, λ by cross-validation" : fmt::format("spline, {:g} λ", factor);
    splines.push_back({name, std::move(found.joint), {.colour = colour++, .width = 1.3}});
  }
  joints.insert(joints.begin() + 1, std::make_move_iterator(splines.begin()),
                std::make_move_iterator(splines.end()));
  return joints;
}

}  // namespace microslip
