// SPDX-License-Identifier: MIT
#include "microslip/calibrate/growing_range.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "support/chain_structure.hpp"
#include "support/simulated_calibration.hpp"

namespace microslip::growing_range_test {
namespace {

// Joints that slip as a whole by almost no force leave the structure none of the resonances: the
// range then is that of its shapes with the joints stuck, and the next joints are found from there.
TEST(GrowingRange, GoesOnWhereNoLevelIsFound) {
  const testing::SimulatedTest test = testing::simulated(
      testing::chain_structure({3.0}, {1e3, 0.0}, {{"foot", -1, 0, testing::tent(6e5, 90.0, 0.6)}},
                               0.004, {6e5}),
      1, 2e-6, 3e-5, 6, 9);
  const CalibrationOptions options{.edges = false, .execution = Execution::serial()};
  LevelStates states(test.given, "p1", options.balance, test.levels, options.execution);
  std::vector<Joint> slipping;
  for (const StructuralJoint& joint : test.given.joints()) {
    slipping.emplace_back(joint.joint.stiffness(), SlipDensity({UniformPart{0.0, 1e-9, 1.0}}));
  }
  std::vector<std::size_t> all(test.levels.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  states.set_joints(slipping);
  states.solve(all);
  for (const std::size_t level : all) ASSERT_TRUE(states.missed(level)) << level;
  GrowingRange range({.levels = test.levels,
                      .frequency = FrequencyUse::kChange,
                      .fit_stiffness = false,
                      .stuck_shapes = false,
                      .forcing = Forcing::kExcitation,
                      .column = {CalibrationEvidence::kNone},
                      .loss_std_given = false,
                      .frequency_std_given = false},
                     test.sought, options, states);
  const CalibratedState found = range.find([] {});
  EXPECT_EQ(found.found, test.levels.size());
}

}  // namespace
}  // namespace microslip::growing_range_test
