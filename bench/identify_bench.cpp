// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstddef>

#include "microslip/base/random.hpp"
#include "microslip/identify/bands.hpp"
#include "microslip/identify/inversion.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip::bench {
namespace {

constexpr double kStiffness = 1.7e5;  // N/m

/// 90 levels as of the published experiment, 2.13 to 300 µm, with 1 % of noise on each D, from a density
/// with a dip and a peak (examples/reference_joint). The same in each run.
Levels reference_levels() {
  const PiecewiseLinearPart density{{0, 4, 8, 14, 20, 28, 36, 44, 52, 60, 75},
                                    {0.02194, 0.01920, 0.01646, 0.01371, 0.01371, 0.01646, 0.01810,
                                     0.01700, 0.01316, 0.00878, 0}};
  const Joint joint(kStiffness, SlipDensity({density}));
  RandomStream random(2014, 2);
  Levels levels;
  for (int i = 0; i < 90; ++i) {
    const double amplitude = 2.13e-6 + (3.0e-4 - 2.13e-6) * i / 89.0;
    levels.amplitude.push_back(amplitude);
    levels.dissipation.push_back(dissipation(joint, amplitude) * (1.0 + 0.01 * random.normal()));
  }
  return levels;
}

InversionOptions options() {
  InversionOptions options;
  options.stiffness = kStiffness;
  return options;
}

/// Both passes, the whole λ path and all that the result holds.
void identify_90_levels(benchmark::State& state) {
  const Levels levels = reference_levels();
  for (auto _ : state) {
    const InversionResult result = invert(levels, options());
    benchmark::DoNotOptimize(result.density.data());
  }
}
BENCHMARK(identify_90_levels)->Unit(benchmark::kMillisecond);

/// 1000 samples of the band on all processors.
void bands_1000(benchmark::State& state) {
  const InversionResult result = invert(reference_levels(), options());
  for (auto _ : state) {
    const DensityBands bands = density_bands(result, {.samples = 1000});
    benchmark::DoNotOptimize(bands.lower.data());
  }
}
BENCHMARK(bands_1000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace microslip::bench
