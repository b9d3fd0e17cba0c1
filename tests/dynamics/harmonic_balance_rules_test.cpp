// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/messages.hpp"
#include "support/structures.hpp"

namespace microslip::harmonic_balance_rules_test {
namespace {

constexpr Quantity kFrequency = Quantity::kAngularFrequency;
constexpr Quantity kForce = Quantity::kForceAmplitude;
constexpr Quantity kResponse = Quantity::kResponse;

using test::expect_message;
using test::message_or;

TEST(HarmonicBalance, NamesTheOptionOutOfRange) {
  const auto build = [](const HarmonicBalanceOptions& options) {
    return message_or(
        "", [&] { HarmonicBalance(testing::one_mass(testing::iwan_joint()), {"mass"}, options); });
  };
  EXPECT_EQ(build({}), "");
  expect_message(build({.harmonics = 0}), "harmonics = 0");
  expect_message(build({.harmonics = 7, .samples = 15}), "samples = 15; must be from 16");
  expect_message(build({.tolerance = 0.0}), "tolerance = 0");
  expect_message(build({.max_iterations = 1}), "max_iterations = 1");
  expect_message(build({.largest_change = 0.0}), "largest_change = 0");
  // Steps so small end nowhere.
  expect_message(build({.largest_change = 5e-324}), "largest_change = 5e-324");
  expect_message(build({.least_points = 0}), "least_points = 0");
  expect_message(build({.max_points = 1}), "max_points = 1");
}

TEST(HarmonicBalance, NamesTheTargetOutOfRange) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  const auto solve = [&](Target first, Target second) {
    return message_or("", [&] { (void)balance.solve(first, second); });
  };
  expect_message(solve({kForce, -1.0}, {kFrequency, 1.0}), "force amplitude = -1");
  expect_message(solve({kForce, 1.0}, {kFrequency, 0.0}), "angular frequency = 0");
  expect_message(solve({kForce, 1.0}, {kForce, 2.0}), "must differ from the first");
  expect_message(solve({kForce, 1.0}, {kResponse, 2.0}), "two frequencies");
  expect_message(solve({Quantity::kPhaseLag, 3.2}, {kResponse, 2.0}), "phase lag = 3.2");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_message(solve({kForce, nan}, {kFrequency, 1.0}), "force amplitude = nan");
  expect_message(message_or("",
                            [&] {
                              (void)balance.solve(kPhaseResonance, {kForce, 1.0}, 3);
                            }),
                 "mode = 3");
  expect_message(message_or("", [&] { (void)balance.frequency_response(1.0, 1.0, 1.0); }),
                 "end of the range = 1");
  expect_message(message_or("",
                            [&] {
                              (void)balance.follow({kForce, 1.0}, Quantity::kPhaseLag, 1.0, 2.0);
                            }),
                 "quantity to follow = phase lag; must not be the phase lag");
  expect_message(message_or("", [&] { (void)balance.backbone({}); }), "number of responses = 0");
  const HarmonicBalance other(testing::one_mass(testing::iwan_joint()), {"mass"}, {.harmonics = 3});
  const auto start = other.solve({kFrequency, 1.2}, {kForce, 0.01});
  expect_message(
      message_or("",
                 [&] {
                   (void)balance.solve({kFrequency, 1.2}, {kForce, 0.01}, start.vibration);
                 }),
      "harmonics of the start = 3; must be those of the options, 5");
}

TEST(HarmonicBalance, NamesTheExcitationAndTheResponseThatCannotBe) {
  const ModalModel linear({{1.0, 0.01}}, {{"mass", {1.0}}, {"node", {0.0}}});
  const auto build = [&](std::vector<Excitation> excitations, ResponsePoint response) {
    return message_or("", [&] {
      HarmonicBalance(JointedStructure(linear, {}, std::move(excitations)), std::move(response));
    });
  };
  expect_message(build({}, {"mass"}), "number of excitations = 0");
  expect_message(build({{"mass", {0.0}}}, {"mass"}), "one of their harmonics not 0");
  expect_message(build({{"elsewhere"}}, {"mass"}), "point = 'elsewhere'");
  expect_message(build({{"mass"}}, {"elsewhere"}), "point = 'elsewhere'");
  expect_message(build({{"mass"}}, {"node"}), "response point = 'node'");
  expect_message(build({{"mass", {1.0, 0.0, 0.0, 0.0, 0.0, 0.1}}}, {"mass"}),
                 "harmonics = 5; must be at least the highest of the excitation, 6");
}

// One mode of 2 rad/s and unit shape holds 4 N/m.
TEST(JointedStructure, TakesNoMoreSpringOutThanTheModesHold) {
  const ModalModel linear({{2.0, 0.01}}, {{"mass", {1.0}}});
  const auto build = [&](double spring) {
    const StructuralJoint joint{
        .name = "a", .joint = testing::iwan_joint(), .shape = {1.0}, .spring_in_modes = spring};
    return message_or("", [&] { JointedStructure(linear, {joint}, {{"mass"}}); });
  };
  EXPECT_EQ(build(4.0), "");
  expect_message(build(4.1), "spring_in_modes of joint 'a' = 4.1 N/m; must be in the modes");
  expect_message(build(4.1), "they contain 4 N/m at most");
}

// A rigid body has no spring, and a thousandth is what four digits of a frequency leave open.
TEST(JointedStructure, TakesNoSpringOutOfRigidBodies) {
  const auto build = [&](double first, double spring) {
    const StructuralJoint joint{.name = "a",
                                .joint = testing::iwan_joint(),
                                .shape = {first, 1.0},
                                .spring_in_modes = spring};
    const ModalModel linear({{0.0, 0.0}, {2.0, 0.01}}, {{"mass", {1.0, 1.0}}});
    return message_or("", [&] { JointedStructure(linear, {joint}, {{"mass"}}); });
  };
  EXPECT_EQ(build(0.0, 4.003), "");
  expect_message(build(0.0, 4.1), "they contain 4 N/m at most");
  expect_message(build(0.5, 1.0), "they contain 0 N/m at most");
}

// Two joints at the mass of one mode of 2 rad/s: 3 N/m of each are 6 of the 4 N/m of the mode.
TEST(JointedStructure, TakesNoMoreSpringsOutThanTheModesHoldTogether) {
  const ModalModel linear({{2.0, 0.01}}, {{"mass", {1.0}}});
  const StructuralJoint joint{
      .name = "a", .joint = testing::iwan_joint(), .shape = {1.0}, .spring_in_modes = 3.0};
  StructuralJoint other = joint;
  other.name = "b";
  const auto build = [&](double second) {
    other.spring_in_modes = second;
    return message_or("", [&] { JointedStructure(linear, {joint, other}, {{"mass"}}); });
  };
  EXPECT_EQ(build(1.0), "");
  expect_message(build(3.0), "spring_in_modes of joints 'a', 'b' = 3, 3 N/m; must be in the modes");
  expect_message(build(3.0), "they contain 66.6667 % of these stiffnesses at most");
  // The softer one alone is too stiff where its shape is large.
  other.shape = {2.0};
  expect_message(build(2.0), "spring_in_modes of joint 'b' = 2 N/m; must be in the modes");
  expect_message(build(2.0), "they contain 1 N/m at most");
}

TEST(JointedStructure, NamesTheJointThatBreaksARule) {
  const ModalModel linear({{1.0, 0.01}, {0.0, 0.0}}, {{"mass", {1.0, 1.0}}});
  const StructuralJoint good{.name = "a", .joint = testing::iwan_joint(), .shape = {1.0, 0.5}};
  const auto build = [&](const std::vector<StructuralJoint>& joints) {
    return message_or("", [&] { JointedStructure(linear, joints, {{"mass"}}); });
  };
  EXPECT_EQ(build({good}), "");
  expect_message(build({good, good}), "name of a joint = 'a'");
  StructuralJoint bad = good;
  bad.shape = {1.0};
  expect_message(build({bad}), "shape of joint 'a' = 1 values; must have 2");
  bad = good;
  bad.spring_in_modes = -1.0;
  expect_message(build({bad}), "spring_in_modes of joint 'a' = -1");
  bad = good;
  bad.series_compliance = -1.0;
  expect_message(build({bad}), "series_compliance of joint 'a' = -1");
  bad = good;
  for (const double beta : {-1.0, HUGE_VAL, std::nan("")}) {
    bad.linear_damping = beta;
    expect_message(build({bad}), fmt::format("linear_damping of joint 'a' = {}; must be 0", beta));
  }
  bad = good;
  bad.shortening = {1.0, 2.0, 3.0, 1.0};
  expect_message(build({bad}), "shortening[1, 0] of joint 'a' = 3");
  bad.shortening = {1.0, 2.0, 2.0, 1.0};
  expect_message(build({bad}),
                 "angular_frequency[1] = 0; must be positive where joint 'a' shortens");
}

}  // namespace
}  // namespace microslip::harmonic_balance_rules_test
