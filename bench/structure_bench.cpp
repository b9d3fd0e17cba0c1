// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include "microslip/structure/beam.hpp"
#include "microslip/structure/beam_modes.hpp"

namespace microslip::bench {
namespace {

/// A steel beam of 583 mm × 40 mm × 5 mm with three sensors and the spring of a stuck contact.
Beam beam_with_sensors() {
  return {.length = 0.583,
          .bending_stiffness = 2.07e11 * 0.04 * 0.005 * 0.005 * 0.005 / 12.0,
          .mass_per_length = 7850.0 * 0.04 * 0.005,
          .tip_stiffness = 153.0,
          .masses = {{0.55, 0.03}, {0.35, 0.01}, {0.18, 0.01}}};
}

/// Frequencies, shapes and the matrix of slope integrals.
void beam_modes_7(benchmark::State& state) {
  const Beam beam = beam_with_sensors();
  for (auto _ : state) {
    const BeamModes modes(beam, 7);
    benchmark::DoNotOptimize(modes.tip_slopes().data());
  }
}
BENCHMARK(beam_modes_7)->Unit(benchmark::kMicrosecond);

/// Preparation of each recording of a test: the spring for its resonance, then 7 modes.
void tuned_beam_modes_7(benchmark::State& state) {
  Beam beam = beam_with_sensors();
  for (auto _ : state) {
    beam.tip_stiffness = spring_for_first_frequency(beam, 55.1);
    const BeamModes modes(beam, 7);
    benchmark::DoNotOptimize(modes.tip_slopes().data());
  }
}
BENCHMARK(tuned_beam_modes_7)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace microslip::bench
