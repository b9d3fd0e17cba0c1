// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "friction_rod.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"

/// @file Frequency responses of structures with many joints: cost by their number, and by that of
/// the harmonics.

namespace microslip::bench {
namespace {

/// From a share of the first frequency of the stuck structure to a share of another.
void follow(benchmark::State& state, const JointedStructure& structure, std::size_t harmonics,
            double force, std::size_t last, double beyond) {
  const HarmonicBalance balance(structure, {"tip"}, {.harmonics = harmonics});
  const std::vector<double> stuck = structure.stuck_frequencies();
  ResponseCurve curve;
  for (auto _ : state) {
    curve = balance.frequency_response(force, 0.6 * stuck[0], beyond * stuck[last]);
  }
  if (!curve.summary.converged()) state.SkipWithError(curve.summary.reason.c_str());
  state.counters["points"] = static_cast<double>(curve.points.size());
  state.counters["evaluations"] = curve.summary.iterations;
  state.counters["peaks"] = static_cast<double>(curve.peaks.size());
  state.counters["peak"] = curve.peaks.empty() ? 0.0 : curve.peaks[0].response;
}

/// 100 modes, nine harmonics, the first resonance.
void frf_50_joints(benchmark::State& state) {
  follow(state, friction_rod(100, 50), 9, 10.0, 0, 1.2);
}
BENCHMARK(frf_50_joints)->Unit(benchmark::kMillisecond);

/// 100 modes, nine harmonics, two resonances.
void frf_10_joints(benchmark::State& state) {
  follow(state, friction_rod(100, 10), 9, 10.0, 1, 1.2);
}
BENCHMARK(frf_10_joints)->Unit(benchmark::kMillisecond);

/// 30 modes, ten joints.
void frf_three_resonances(benchmark::State& state) {
  follow(state, friction_rod(30, 10), static_cast<std::size_t>(state.range(0)), 10.0, 2, 1.1);
}
BENCHMARK(frf_three_resonances)
    ->ArgName("H")
    ->Arg(3)
    ->Arg(9)
    ->Arg(25)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
