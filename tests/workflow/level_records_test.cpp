// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/level_records.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace microslip::level_records_test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// 3 N cos(ωt) + 1 N sin(3ωt) at 20 Hz, 50 cycles.
Recording steady_force() {
  Recording recording{.source = "steady", .axis = {}, .channels = {}, .attributes = {}};
  recording.axis.step = 1e-3;
  Channel force{"force", kForce, {}, {}, {}};
  for (std::size_t i = 0; i < 2500; ++i) {
    const double t = recording.axis.at(i);
    force.values.push_back(3.0 * std::cos(kTurn * 20.0 * t) + std::sin(kTurn * 60.0 * t));
  }
  recording.channels = {force};
  return recording;
}

// Amplitudes of exact harmonics are found to the accuracy of the fit of the frequency.
TEST(LevelRecords, HarmonicsAndTwoCyclesOfARecord) {
  const LevelRecord record = level_record(steady_force(), "r", 1000);
  const std::vector<double>& harmonics = record.harmonics.at(0).recorded;
  EXPECT_NEAR(harmonics[0], 3.0, 1e-9);
  EXPECT_NEAR(harmonics[1], 0.0, 1e-9);
  EXPECT_NEAR(harmonics[2], 1.0, 1e-9);
  // From where the fundamental rises through 0, for two cycles of 50 ms.
  EXPECT_NEAR(record.signals.at(0).time.back(), 0.1, 2e-3);
  EXPECT_TRUE(level_record(steady_force(), "r", 0).signals.empty());
}

TEST(LevelRecords, SpreadKeepsTheEnds) {
  EXPECT_EQ(spread({"a", "b", "c", "d", "e"}, 3), (std::vector<std::string>{"a", "c", "e"}));
  EXPECT_EQ(spread({"a"}, 3), (std::vector<std::string>{"a"}));
}

TEST(LevelRecords, TheForceOfAVirtualLevel) {
  VirtualLevel level;
  level.response = 2.0;
  for (DrivenVibration* state : {&level.uncontrolled, &level.controlled}) {
    state->vibration.angular_frequency = kTurn * 10.0;
    state->force = {0.0, 4.0, 0.0, {0.0, -1.0}};  // 4 cos + sin of three times the angle
  }
  level.controlled.force[3] = 0.02;
  const std::vector<ForceControlLevel> controls = force_controls({&level, 1}, 3);
  EXPECT_EQ(controls.at(0).before, (std::vector{0.0, 0.25}));
  EXPECT_EQ(controls.at(0).after, (std::vector{0.0, 0.005}));
  const Curve curve = force_over_cycle(level.uncontrolled, 8);
  EXPECT_NEAR(curve.x.back(), 0.1, 1e-15);
  EXPECT_NEAR(curve.y[1], 4.0 * std::cos(kTurn / 8.0) + std::sin(3.0 * kTurn / 8.0), 1e-14);
}

}  // namespace
}  // namespace microslip::level_records_test
