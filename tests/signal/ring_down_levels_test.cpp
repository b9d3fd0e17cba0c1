// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/ring_down_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "microslip/base/error.hpp"

namespace microslip::ring_down_levels_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Windows of 0.4 s, 0.1 s apart.
RingDown decay() {
  RingDown decay;
  for (int i = 0; i < 9; ++i) {
    const double a = 1e-4 * std::exp(-0.2 * i);
    decay.time.push_back(0.2 + 0.1 * i);
    decay.amplitude.push_back(a);
    decay.amplitude_std.push_back(0.01 * a);
    decay.frequency.push_back(50.0 + 0.1 * i);
    decay.frequency_std.push_back(0.002);
    decay.damping_ratio.push_back(0.01);
    decay.damping_ratio_std.push_back(1e-4);
    decay.loss.push_back(3e-3 * a * a);
    decay.loss_std.push_back(3e-5 * a * a);
    decay.window.push_back(0.4);
  }
  return decay;
}

TEST(RingDownLevels, AreHalfAWindowApart) {
  const RingDownLevels levels = levels_of(decay(), {.modal_mass = 2.0});
  EXPECT_EQ(levels.time.size(), 5U);
  for (std::size_t i = 1; i < levels.time.size(); ++i) {
    EXPECT_NEAR(levels.time[i] - levels.time[i - 1], 0.2, 1e-12);
  }
}

TEST(RingDownLevels, HaveTheFlagsOfTheWindowsBesideThem) {
  RingDown flagged = decay();
  flagged.flags.assign(flagged.size(), "");
  flagged.flags[2] = "shape_moves";
  flagged.flags[3] =
      "sensors_differ shape_moves";  // no level, as near to the second as to the third
  const RingDownLevels levels = damping_levels_of(flagged);
  ASSERT_EQ(levels.flags.size(), 5U);
  EXPECT_EQ(levels.flags[0] + levels.flags[3] + levels.flags[4], "");
  EXPECT_EQ(levels.flags[1] + levels.flags[2], "shape_moves sensors_differ");
}

TEST(RingDownLevels, ScaleWithMassAndRatio) {
  const RingDown from = decay();
  const RingDownLevels levels = levels_of(from, {.modal_mass = 2.0, .joint_ratio = -0.3});
  EXPECT_DOUBLE_EQ(levels.amplitude[1], 0.3 * from.amplitude[2]);
  EXPECT_DOUBLE_EQ(levels.amplitude_std[1], 0.3 * from.amplitude_std[2]);
  EXPECT_DOUBLE_EQ(levels.dissipation[1], 2.0 * from.loss[2]);
  EXPECT_DOUBLE_EQ(levels.dissipation_std[1], 2.0 * from.loss_std[2]);
  EXPECT_EQ(levels.frequency[1], from.frequency[2]);
  EXPECT_EQ(levels.damping_ratio[1], from.damping_ratio[2]);
  EXPECT_TRUE(levels.secant_stiffness.empty());
}

TEST(RingDownLevels, LoseTheLinearLossOfTheStickState) {
  RingDown from = decay();
  for (std::size_t i = 0; i < from.size(); ++i)
    from.loss[i] = 500.0 * std::pow(from.amplitude[i], 2);
  const double a = from.amplitude[0];
  const double eta = 0.001;
  const RingDownLevels given =
      levels_of(from, {.modal_mass = 2.0, .loss_factor = eta, .stick_frequency = 52.0});
  EXPECT_NEAR(given.dissipation[0],
              2.0 * from.loss[0] - kPi * eta * 2.0 * std::pow(2.0 * kPi * 52.0 * a, 2),
              1e-12 * from.loss[0]);
  const RingDownLevels found = levels_of(from, {.modal_mass = 2.0, .loss_factor = eta});
  const double highest = from.frequency.back();
  EXPECT_NEAR(found.dissipation[0],
              2.0 * from.loss[0] - kPi * eta * 2.0 * std::pow(2.0 * kPi * highest * a, 2),
              1e-12 * from.loss[0]);
}

TEST(RingDownLevels, LeaveOutWhatTheLinearLossExceeds) {
  const RingDownLevels levels = levels_of(decay(), {.modal_mass = 2.0, .loss_factor = 0.1});
  EXPECT_TRUE(levels.amplitude.empty());
  ASSERT_EQ(levels.warnings.size(), 1U);
  EXPECT_EQ(levels.warnings[0].code, "linear_loss_exceeds_all");
}

TEST(RingDownLevels, GiveTheSecantStiffness) {
  // A joint of ratio R on a mode of stiffness m ω₀²: its change Δk lowers m ω² by R²Δk.
  const RingDown from = decay();
  const RingDownLevels levels = levels_of(
      from,
      {.modal_mass = 2.0, .joint_ratio = 0.5, .stick_frequency = 51.0, .joint_stiffness = 1e5});
  ASSERT_EQ(levels.secant_stiffness.size(), levels.amplitude.size());
  const double change = levels.secant_stiffness[0] - 1e5;
  EXPECT_NEAR(4.0 * kPi * kPi * (50.0 * 50.0 - 51.0 * 51.0) * 2.0, 0.25 * change, 1e-8);
  EXPECT_NEAR(levels.secant_stiffness_std[0], 8.0 * kPi * kPi * 50.0 * 0.002 * 2.0 / 0.25, 1e-8);
}

TEST(RingDownLevels, GiveNoSecantStiffnessBelowZero) {
  const RingDownLevels levels =
      levels_of(decay(), {.modal_mass = 2.0, .stick_frequency = 51.0, .joint_stiffness = 10.0});
  EXPECT_TRUE(levels.secant_stiffness.empty());
  ASSERT_EQ(levels.warnings.size(), 1U);
  EXPECT_EQ(levels.warnings[0].code, "secant_not_positive");
}

TEST(RingDownLevels, RefuseOptionsOutOfRange) {
  EXPECT_THROW((void)levels_of(decay(), {}), InputError);
  EXPECT_THROW((void)levels_of(decay(), {.modal_mass = 1.0, .joint_ratio = 0.0}), InputError);
  EXPECT_THROW((void)levels_of(decay(), {.modal_mass = 1.0, .loss_factor = -0.1}), InputError);
  EXPECT_THROW((void)levels_of(decay(), {.modal_mass = 1.0, .stick_frequency = 0.0}), InputError);
  EXPECT_THROW((void)levels_of(decay(), {.modal_mass = 1.0, .joint_stiffness = 1e5}), InputError);
}

}  // namespace
}  // namespace microslip::ring_down_levels_test
