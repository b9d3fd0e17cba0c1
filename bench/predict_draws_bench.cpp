// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/workflow/predict/response_draws.hpp"
#include "support/structures.hpp"

namespace microslip::bench {
namespace {

constexpr std::size_t kModes = 7;

/// The reference rig; without the shortening of its beam a rig of seven modes and one joint as any
/// other structure is.
JointedStructure rig_of_seven_modes(bool shortens) {
  const JointedStructure rig = testing::friction_rig(kModes);
  StructuralJoint contact = rig.joints()[0];
  if (!shortens) contact.shortening.clear();
  return {rig.linear(),
          {std::move(contact)},
          {rig.excitations().begin(), rig.excitations().end()},
          rig.damping()};
}

/// Draws of the frequencies, the loss factors and the normal load through an FRF of 50 to 60 Hz, on
/// all threads. @param shortens  as above.
void draw_frf(benchmark::State& state, bool shortens) {
  const JointedStructure rig = rig_of_seven_modes(shortens);
  const HarmonicBalance balance(rig, {"force"});
  constexpr double kTwoPi = 6.283185307179586;
  const ResponseRange range{{Quantity::kForceAmplitude, 2.0}, kTwoPi * 50.0, kTwoPi * 60.0};
  const ResponseCurve curve =
      balance.follow(range.kept, Quantity::kAngularFrequency, range.from, range.to);
  const StructureDraws draws(rig,
                             {.frequency = std::vector<double>(kModes, 0.001),
                              .loss_factor = std::vector<double>(kModes, 0.05),
                              .normal_load = {0.1}},
                             {}, JointPairing::kIndependent, 1);
  const DrawOptions options{.count = static_cast<std::size_t>(state.range(0))};
  for (auto _ : state) {
    const ResponseSpread spread = response_spread(balance, curve, range, draws, options);
    if (spread.taken.failed() > 0) state.SkipWithError("draws failed");
    benchmark::DoNotOptimize(spread.band.lower.data());
  }
}

void predict_frf_draws(benchmark::State& state) { draw_frf(state, false); }
BENCHMARK(predict_frf_draws)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

void predict_frf_draws_shortening(benchmark::State& state) { draw_frf(state, true); }
BENCHMARK(predict_frf_draws_shortening)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace microslip::bench
