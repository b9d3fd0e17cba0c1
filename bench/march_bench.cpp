// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "largest_error.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "newmark_march.hpp"
#include "support/structures.hpp"

namespace microslip::bench {
namespace {

JointedStructure rig_of_7_modes(bool shortens) {
  const JointedStructure structure = testing::friction_rig(7);
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  if (!shortens) {
    joints[0].shortening.clear();
    joints[0].series_compliance = 0.0;
  }
  return JointedStructure(structure.linear(), std::move(joints), {{"force"}});
}

/// 8 N at 55 Hz from rest for half a second, 8192 samples per second: the joint slips at up to 50
/// N.
LoadHistory steady_force(double rate) {
  LoadHistory loads;
  loads.forces.push_back({"force", {}});
  const auto count = static_cast<std::size_t>(0.5 * rate) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    loads.time.push_back(static_cast<double>(i) / rate);
    loads.forces[0].force.push_back(8.0 *
                                    std::sin(2.0 * std::numbers::pi * 55.0 * loads.time.back()));
  }
  return loads;
}

/// Largest difference of a displacement at the exciter from that with steps of a sixteenth of the
/// samples, over the largest displacement.
double relative_error(const JointedStructure& structure, const LoadHistory& loads,
                      const std::vector<double>& found) {
  const MarchOptions options{
      .step = (loads.time[1] - loads.time[0]) / 16.0, .points = {"force"}, .tolerance = 1e-12};
  const auto exact = march(structure, loads, options).points[0].displacement;
  return largest_error(found, exact);
}

/// The reference rig with its 7 modes and its joint: steps per second (items_per_second), and the
/// error of steps of this length. @param state  rate of the samples, Hz; with shortening or
/// without.
void march_7_modes(benchmark::State& state) {
  const auto rate = static_cast<double>(state.range(0));
  const JointedStructure structure = rig_of_7_modes(state.range(1) != 0);
  const LoadHistory loads = steady_force(rate);
  MarchOptions options{.step = 1.0 / rate, .points = {"force"}};
  options.estimate_error = false;  // one march is timed, not the second that judges it
  MarchResult result;
  std::size_t steps = 0;
  for (auto _ : state) {
    result = march(structure, loads, options);
    steps += result.steps;
  }
  if (!result.summary.converged()) state.SkipWithError(result.summary.reason.c_str());
  state.SetItemsProcessed(static_cast<int64_t>(steps));
  state.counters["relative_error"] =
      relative_error(structure, loads, result.points[0].displacement);
  state.counters["energy_imbalance"] = result.energy.imbalance();
  state.counters["evaluations_per_step"] =
      static_cast<double>(result.summary.iterations) / static_cast<double>(result.steps);
}
BENCHMARK(march_7_modes)
    ->ArgNames({"rate", "shortening"})
    ->Args({8192, 0})
    ->Args({8192, 1})
    ->Args({32768, 0})
    ->Args({32768, 1})
    ->Unit(benchmark::kMillisecond);

/// The march without shortening by Newmark's scheme.
void newmark_7_modes(benchmark::State& state) {
  const auto rate = static_cast<double>(state.range(0));
  const JointedStructure structure = rig_of_7_modes(false);
  const LoadHistory loads = steady_force(rate);
  std::vector<double> result;
  for (auto _ : state) {
    result = newmark_march(structure, loads.forces[0].force, 1.0 / rate, 1e-8);
    benchmark::DoNotOptimize(result.data());
  }
  state.SetItemsProcessed(static_cast<int64_t>(result.size() - 1) *
                          static_cast<int64_t>(state.iterations()));
  state.counters["relative_error"] = relative_error(structure, loads, result);
}
BENCHMARK(newmark_7_modes)->ArgName("rate")->Arg(8192)->Arg(32768)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
