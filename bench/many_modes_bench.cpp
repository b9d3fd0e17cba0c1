// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "friction_rod.hpp"
#include "largest_error.hpp"
#include "low_passed_noise.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/march/march.hpp"

/// @file Marches of structures with many modes and joints.

namespace microslip::bench {
namespace {

/// Largest difference of a displacement at the tip from that with a step of 1/2¹⁷ s, over the
/// largest displacement.
double relative_error(const JointedStructure& structure, const LoadHistory& loads,
                      const std::vector<double>& found) {
  const MarchOptions options{
      .step = std::exp2(-17.0), .points = {"tip"}, .tolerance = 1e-12, .estimate_error = false};
  const auto exact = march(structure, loads, options).points[0].displacement;
  return largest_error(found, exact);
}

/// A second with the step that march() chooses.
void march_second(benchmark::State& state, std::size_t modes, std::size_t joints) {
  const JointedStructure structure = friction_rod(modes, joints);
  const LoadHistory loads = low_passed_noise(1.0, 4096.0);
  MarchResult result;
  for (auto _ : state) result = march(structure, loads, {.points = {"tip"}});
  if (!result.summary.converged()) state.SkipWithError(result.summary.reason.c_str());
  state.counters["steps"] = static_cast<double>(result.steps);
  state.counters["reversals"] = static_cast<double>(result.reversals);
  state.counters["kinks"] = static_cast<double>(result.kinks);
  state.counters["evaluations_per_step"] =
      static_cast<double>(result.summary.iterations) / static_cast<double>(result.steps);
  state.counters["estimated_error"] = result.error_estimate.value_or(NAN);
  state.counters["relative_error"] =
      relative_error(structure, loads, result.points[0].displacement);
}

/// One joint.
void march_300_modes(benchmark::State& state) {
  march_second(state, static_cast<std::size_t>(state.range(0)), 1);
}
BENCHMARK(march_300_modes)
    ->ArgName("modes")
    ->Arg(3)
    ->Arg(30)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);

void march_300_modes_10_joints(benchmark::State& state) { march_second(state, 300, 10); }
BENCHMARK(march_300_modes_10_joints)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
