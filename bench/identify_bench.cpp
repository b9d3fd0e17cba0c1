// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <vector>

#include "microslip/identify/assemblies/assemblies.hpp"
#include "microslip/identify/inversion/bands.hpp"
#include "microslip/identify/inversion/further_levels.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "support/assemblies.hpp"
#include "support/densities.hpp"

namespace microslip::bench {
namespace {

/// 90 levels as of the published experiment, 2.13 to 300 µm, with 1 % of noise on each D, from a
/// density with a dip and a peak. The same in each run.
Levels reference_levels() { return testing::noisy_levels(testing::reference_joint(), 2); }

void invert_reference_levels(benchmark::State& state, bool edges) {
  const Levels levels = reference_levels();
  InversionOptions options;
  options.edges = edges;
  for (auto _ : state) {
    const InversionResult result = invert(levels, testing::kStiffness, options);
    benchmark::DoNotOptimize(result.density.data());
  }
}

/// Both passes, the whole λ path and all that the result holds, of a smooth density.
void identify_90_levels(benchmark::State& state) { invert_reference_levels(state, false); }
BENCHMARK(identify_90_levels)->Unit(benchmark::kMillisecond);

/// 90 levels with edges and a trend of the smoothness sought.
void identify_90_levels_with_edges(benchmark::State& state) {
  invert_reference_levels(state, true);
}
BENCHMARK(identify_90_levels_with_edges)->Unit(benchmark::kMillisecond);

/// 90 levels with 1000 posterior draws and their band, on one processor.
/// @param state  reports the smallest number of equivalent independent draws.
void identify_with_1000_draws(benchmark::State& state) {
  const Levels levels = reference_levels();
  double effective = 0.0;
  for (auto _ : state) {
    const InversionResult result = invert(levels, testing::kStiffness);
    const DensityBands bands =
        density_bands(result, {.samples = 1000, .execution = Execution::serial()});
    benchmark::DoNotOptimize(bands.lower.data());
    effective = bands.effective_samples;
  }
  state.counters["effective"] = effective;
}
BENCHMARK(identify_with_1000_draws)->Unit(benchmark::kMillisecond);

/// Five assemblies of 30 levels each, 1000 draws of all and of the next one, on one processor.
/// @param state  reports the number of equivalent independent draws of the spreads.
void identify_five_assemblies(benchmark::State& state) {
  const auto assemblies = testing::measured_assemblies(testing::reference_joint(), {}, 5, 1);
  AssembliesOptions options;
  options.execution = Execution::serial();
  double effective = 0.0;
  for (auto _ : state) {
    const AssembliesResult result = identify_assemblies(assemblies, {}, options);
    benchmark::DoNotOptimize(result.draws.data());
    effective = result.effective_draws;
  }
  state.counters["effective"] = effective;
}
BENCHMARK(identify_five_assemblies)->Unit(benchmark::kMillisecond);

/// A plan of ten further levels for the density, from the same, by 1000 draws on one processor.
void plan_10_levels_after_90(benchmark::State& state) {
  const LevelEvidence evidence(reference_levels());
  for (auto _ : state) {
    const InversionResult result = invert(evidence, testing::kStiffness);
    const std::vector<Joint> joints = drawn_joints(
        result, result.posterior.samples(1, 1000, Execution::serial()), testing::kStiffness);
    const FurtherLevels further =
        further_levels(evidence, result, joints, testing::equal_steps(128));
    const LevelDesign design =
        design_levels(further, density_target(joints, {0.5, testing::kReach}), 10);
    benchmark::DoNotOptimize(design.after);
  }
}
BENCHMARK(plan_10_levels_after_90)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
