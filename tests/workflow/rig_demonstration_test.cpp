// SPDX-License-Identifier: MIT
#include "microslip/workflow/measure/rig_demonstration.hpp"

#include <gtest/gtest.h>

#include "microslip/identify/methods/density_comparison.hpp"
#include "support/rigs.hpp"

namespace microslip::rig_demonstration_test {
namespace {

// Twelve levels of a uniform joint: that its density is found to 10 % is what tests/validation
// bounds by 5 % for ninety.
TEST(RigDemonstration, FindsTheJointThatWasPutIn) {
  Rig rig = testing::reference_rig();
  rig.test->count = 12;
  rig.contact.joint = "truth.json";
  const Joint truth(1.7e5, SlipDensity({UniformPart{.from = 0.0, .to = 60.0, .weight = 1.0}}));
  const RigDemonstration done = demonstrate(rig, truth, 3, [](const char*) { return Progress(); });
  EXPECT_TRUE(done.converged());
  EXPECT_EQ(done.levels.levels.size(), 12);
  EXPECT_EQ(done.recordings.names.back(), "recordings/level_12.csv");
  EXPECT_EQ(done.recordings.before_control.size(), 1);
  EXPECT_LT(density_error(done.found, truth.density()), 0.1);
  EXPECT_TRUE(without_truth(done.rig).contact.joint.empty());
}

}  // namespace
}  // namespace microslip::rig_demonstration_test
