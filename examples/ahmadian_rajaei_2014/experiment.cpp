// SPDX-License-Identifier: MIT
#include "experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::Levels;
using microslip::Recording;
using microslip::ReducedLevel;
using microslip::Rig;

constexpr std::uint64_t kSeed = 1;

/// 90 levels from 30 mg to 4 g with one second of record each; fewer on the reduced grid.
Rig rig_of(const Grid& grid, const std::string& examples) {
  Rig rig = microslip::read_rig(examples + "/reference_rig/rig.toml");
  if (grid.reduced) {
    rig.test->count = 18;
    rig.test->sampling_rate = 2048.0;
  }
  return rig;
}

Levels measured_of(const std::vector<ReducedLevel>& levels) {
  Levels measured;
  for (const ReducedLevel& level : levels) {
    measured.amplitude.push_back(level.amplitude.value);
    measured.amplitude_std.push_back(level.amplitude.std);
    measured.dissipation.push_back(level.dissipation.value);
    measured.dissipation_std.push_back(level.dissipation.std);
  }
  return measured;
}

Levels scattered_of(Levels levels) {
  microslip::RandomStream random(kSeed, 0);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels.dissipation_std[i] = kScatter * levels.dissipation[i];
    levels.dissipation[i] += levels.dissipation_std[i] * random.normal();
  }
  return levels;
}

std::vector<ReducedLevel> reduce(const microslip::Reducer& reducer,
                                 const std::vector<Recording>& recordings) {
  const auto one = [&](std::size_t i) { return std::vector<Recording>{recordings[i]}; };
  return microslip::reduce_batch(reducer, recordings.size(), one).levels;
}

}  // namespace

RecordedTest record_test(const Rig& rig, const microslip::StickState& state,
                         const microslip::Joint& truth, std::uint64_t seed) {
  RecordedTest made{.test = microslip::measure_virtually(rig, truth), .recordings = {}};
  if (!made.test.summary.converged()) throw microslip::Error(made.test.summary.full());
  for (const microslip::VirtualLevel& level : made.test.levels) {
    made.recordings.push_back(
        microslip::virtual_record(rig, state, level.controlled, seed, made.recordings.size()));
  }
  return made;
}

microslip::Joint reference_joint(const std::string& examples) {
  return microslip::read_joint(examples + "/reference_rig/joint.json").joint;
}

Experiment run_experiment(const Grid& grid, const std::string& examples) {
  const Rig rig = rig_of(grid, examples);
  microslip::Reducer reducer(rig);
  microslip::StickState state = microslip::stick_state(rig, rig.test->modes);
  microslip::Joint truth = reference_joint(examples);
  RecordedTest recorded = record_test(rig, state, truth, kSeed);
  std::vector<ReducedLevel> levels = reduce(reducer, recorded.recordings);
  Levels measured = measured_of(levels);
  Levels scattered = scattered_of(measured);
  microslip::IdentificationOptions options;
  options.bands = microslip::BandOptions{.samples = grid.pick<std::size_t>(1000, 100)};
  microslip::Identification found =
      microslip::identify(scattered, reducer.state().stiffness, options);
  return {.reducer = std::move(reducer),
          .truth = std::move(truth),
          .state = std::move(state),
          .test = std::move(recorded.test),
          .levels = std::move(levels),
          .measured = std::move(measured),
          .scattered = std::move(scattered),
          .found = std::move(found)};
}

}  // namespace ahmadian_rajaei
