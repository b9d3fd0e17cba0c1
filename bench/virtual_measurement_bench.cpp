// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "microslip/rig/virtual_test/virtual_measurement.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

namespace {

using namespace microslip;

/// Tested as in the published experiment.
Rig noisy_rig() {
  Rig rig = testing::reference_rig();
  rig.test->frequency_resolution = 0.1;
  rig.noise = RigNoise{.force = 0.002, .acceleration = 0.005, .vibrometer = 2e-8};
  return rig;
}

void run(benchmark::State& state, const VirtualMeasurementOptions& options) {
  const Rig rig = noisy_rig();
  const Joint joint = testing::reference_joint();
  VirtualMeasurement test;
  for (auto _ : state) test = measure_virtually(rig, joint, options);
  if (!test.summary.converged()) state.SkipWithError(test.summary.reason.c_str());
  state.counters["balances"] = test.summary.iterations;
}

/// 90 levels with shaker and force control, solving alone.
void virtual_test_90_levels(benchmark::State& state) { run(state, {}); }
BENCHMARK(virtual_test_90_levels)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The virtual test under a pure force.
void virtual_test_90_levels_pure(benchmark::State& state) { run(state, {.shaker = false}); }
BENCHMARK(virtual_test_90_levels_pure)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One record of a second with noise.
void virtual_record_8192(benchmark::State& state) {
  Rig rig = noisy_rig();
  rig.test->count = 1;
  const StickState stick = stick_state(rig);
  const VirtualMeasurement test = measure_virtually(rig, testing::reference_joint());
  for (auto _ : state) {
    benchmark::DoNotOptimize(virtual_record(rig, stick, test.levels[0].controlled, 1, 0));
  }
}
BENCHMARK(virtual_record_8192)->Unit(benchmark::kMillisecond);

}  // namespace
