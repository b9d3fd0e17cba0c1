// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/levels.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"
#include "microslip/signal/recording/recording.hpp"
#include "reproduction.hpp"

/// @file
/// The experiment of [AR14], on the reference rig of this project.

namespace ahmadian_rajaei {

/// Standard deviation of the scatter that is added to each D before the identification, relative.
/// The noise of the virtual sensors alone moves D by less than 0.01 % in the upper half of the
/// levels, which needs no smoothing; real contacts do not repeat that well. A number of our own.
inline constexpr double kScatter = 0.01;

struct Experiment {
  microslip::Reducer reducer;  ///< with the rig
  microslip::Joint truth;      ///< the joint of the virtual test, which the reduction does not know
  microslip::StickState state;  ///< of the virtual test
  microslip::VirtualMeasurement test;
  std::vector<microslip::ReducedLevel> levels;  ///< by rising response
  microslip::Levels measured;                   ///< those levels, for the identification
  microslip::Levels scattered;                  ///< with kScatter on D, given as its deviation
  microslip::Identification found;              ///< from those, by inversion with its 95 % band
};

struct RecordedTest {
  microslip::VirtualMeasurement test;
  std::vector<microslip::Recording> recordings;  ///< one per level, under control of the force
};

/// Runs the virtual test of a rig and records it. @throws microslip::Error  where a level is not
/// found.
[[nodiscard]] RecordedTest record_test(const microslip::Rig& rig,
                                       const microslip::StickState& state,
                                       const microslip::Joint& truth, std::uint64_t seed);

/// The true joint of the reference rig. @param examples  the folder examples of microslip.
[[nodiscard]] microslip::Joint reference_joint(const std::string& examples);

/// Runs the test, reduces its recordings and identifies the joint.
/// @param examples  the folder examples of microslip.
[[nodiscard]] Experiment run_experiment(const Grid& grid, const std::string& examples);

}  // namespace ahmadian_rajaei
