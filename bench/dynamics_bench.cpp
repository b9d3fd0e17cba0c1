// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "band_limited_path.hpp"
#include "microslip/dynamics/cycle/harmonic_force.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "support/rigs.hpp"
#include "support/structures.hpp"

namespace microslip::bench {
namespace {

/// Force harmonics of a joint and all their derivatives, for a motion without inner loops.
void aft_force_jacobian(benchmark::State& state) {
  const Joint joint = joint_of_100_segments();
  const auto harmonics = static_cast<std::size_t>(state.range(0));
  HarmonicForce balance(harmonics, static_cast<std::size_t>(state.range(1)));
  std::vector<double> x(2 * harmonics + 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = 2e-4 / std::pow(4.0 + static_cast<double>(i), 2);
  x[1] = 2e-4;
  std::vector<double> force(x.size());
  std::vector<double> jacobian(x.size() * x.size());
  for (auto _ : state) {
    balance.evaluate(joint, x, force, jacobian);
    benchmark::DoNotOptimize(jacobian.data());
  }
}
BENCHMARK(aft_force_jacobian)
    ->ArgNames({"H", "N"})
    ->Args({3, 1024})
    ->Args({9, 512})
    ->Unit(benchmark::kMicrosecond);

/// The mass with Segalman's joint.
HarmonicBalance one_mass() {
  return HarmonicBalance(testing::one_mass(testing::iwan_joint()), {"mass"},
                         {.harmonics = 3, .samples = 256});
}

void report(benchmark::State& state, const ResponseCurve& curve) {
  if (!curve.summary.converged()) state.SkipWithError(curve.summary.reason.c_str());
  state.counters["points"] = static_cast<double>(curve.points.size());
  state.counters["evaluations"] = curve.summary.iterations;
}

/// A resonance at constant force, with its peak.
void frf_sdof_curve(benchmark::State& state) {
  const HarmonicBalance balance = one_mass();
  ResponseCurve curve;
  for (auto _ : state) curve = balance.frequency_response(0.02, 0.8, 1.1);
  report(state, curve);
}
BENCHMARK(frf_sdof_curve)->Unit(benchmark::kMillisecond);

/// The same with a joint of many sliders, as others export them.
void frf_atoms(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto n = static_cast<double>(count);
  AtomsPart atoms{std::vector<double>(count), std::vector<double>(count, 0.8 / n)};
  for (std::size_t i = 0; i < count; ++i) {
    atoms.slip_force[i] = 0.1 * (static_cast<double>(i) + 0.5) / n;
  }
  const Joint joint(testing::iwan_joint().stiffness(), SlipDensity({std::move(atoms)}));
  const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                {.harmonics = 3, .samples = 256});
  ResponseCurve curve;
  for (auto _ : state) curve = balance.frequency_response(0.02, 0.8, 1.1);
  report(state, curve);
}
BENCHMARK(frf_atoms)->RangeMultiplier(10)->Range(100, 10000)->Unit(benchmark::kMillisecond);

/// The range at constant response.
void frf_constant_response(benchmark::State& state) {
  const HarmonicBalance balance = one_mass();
  ResponseCurve curve;
  for (auto _ : state) curve = balance.constant_response(0.5, 0.8, 1.1);
  report(state, curve);
}
BENCHMARK(frf_constant_response)->Unit(benchmark::kMillisecond);

/// The reference rig by seven modes, with the shortening of the beam and a joint of 100 segments.
HarmonicBalance friction_rig() {
  const Rig rig = testing::reference_rig();
  return HarmonicBalance(rig_structure(rig, stick_state(rig, 7), joint_of_100_segments()),
                         {"force", ResponseKind::kAcceleration}, {.harmonics = 9, .samples = 512});
}

/// A level of a virtual test, from the level before: an eightieth of the highest below.
void rig_level(benchmark::State& state) {
  const HarmonicBalance balance = friction_rig();
  const Target level{Quantity::kResponse, 19.62};
  const VibrationResult before = balance.solve(kPhaseResonance, {Quantity::kResponse, 19.18});
  VibrationResult result;
  for (auto _ : state) result = balance.solve(kPhaseResonance, level, before.vibration);
  if (!result.summary.converged()) state.SkipWithError(result.summary.reason.c_str());
  state.counters["evaluations"] = result.summary.iterations;
}
BENCHMARK(rig_level)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace microslip::bench
