// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/stick_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/rigs.hpp"

namespace microslip::stick_state_test {
namespace {

using test::message_of;
using testing::reference_rig;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A beam without masses on a joint, of the numbers of the reference rig.
Rig bare_rig(double stiffness) {
  Rig rig = reference_rig();
  rig.masses.clear();
  rig.contact = {.rod_radius = 0.030, .stiffness = stiffness};
  return rig;
}

// βL of a beam that is clamped at 0 and pinned or clamped at L: tan x = tanh x and
// cos x cosh x = 1.
constexpr double kPinned = 3.9266023120479185;
constexpr double kClamped = 4.7300407448627038;

/// f = (βL)²/(2πL²) √(EI/(ρbh)), Hz.
double first_frequency(const RigBeam& beam, double beta_length) {
  return std::pow(beta_length / beam.length, 2) / kTurn *
         std::sqrt(beam.bending_stiffness() / (beam.mass_density * beam.area()));
}

TEST(StickState, LiesBetweenAPinnedAndAClampedEnd) {
  const double pinned = first_frequency(*reference_rig().beam(), kPinned);
  const double clamped = first_frequency(*reference_rig().beam(), kClamped);
  // 1e-9: a spring of 1e-6 N/m or 1e15 N/m changes the frequency by less, roots come to rounding.
  EXPECT_NEAR(stick_state(bare_rig(1e-6), 3).omega[0] / (kTurn * pinned), 1.0, 1e-9);
  EXPECT_NEAR(stick_state(bare_rig(1e15), 3).omega[0] / (kTurn * clamped), 1.0, 1e-9);
  double last = pinned;
  for (double stiffness = 1e2; stiffness < 1e9; stiffness *= 10.0) {
    const double frequency = stick_state(bare_rig(stiffness), 3).omega[0] / kTurn;
    EXPECT_GT(frequency, last) << stiffness;
    last = frequency;
  }
  EXPECT_LT(last, clamped);
}

TEST(StickState, HasTheRodAndTheAxialCompliance) {
  const Rig rig = reference_rig();
  const StickState state = stick_state(rig);
  EXPECT_DOUBLE_EQ(state.axial_compliance, 0.583 / (0.040 * 0.005 * 2.07e11));
  Rig wide = rig;
  wide.contact = {.rod_radius = 0.060, .stiffness = *rig.contact.stiffness / 4.0};
  const StickState of_wide = stick_state(wide);  // k r² is the same
  for (std::size_t i = 0; i < state.modes(); ++i) {
    EXPECT_DOUBLE_EQ(of_wide.omega[i], state.omega[i]);
    EXPECT_DOUBLE_EQ(of_wide.joint[i], 2.0 * state.joint[i]);
  }
}

TEST(StickState, ShorteningIsSymmetricAndNotNegative) {
  const StickState state = stick_state(reference_rig());
  const std::size_t n = state.modes();
  ASSERT_EQ(state.shortening.size(), n * n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_GT(state.shortening[i * n + i], 0.0);
    for (std::size_t r = 0; r < n; ++r) {
      const double product = state.shortening[i * n + r] * state.shortening[r * n + i];
      // 1e-12: integrals of terms some 100 times as large, which cancel.
      EXPECT_NEAR(state.shortening[i * n + r], state.shortening[r * n + i],
                  1e-12 * state.shortening[i * n + i]);
      EXPECT_LE(product, state.shortening[i * n + i] * state.shortening[r * n + r]);  // Schwarz
    }
  }
}

TEST(StickState, TakesTheGivenNumberOfModes) {
  Rig rig = reference_rig();
  rig.test->modes = 5;
  EXPECT_EQ(stick_state(rig).modes(), 5U);
  EXPECT_EQ(stick_state(rig, 9).modes(), 9U);
  rig.test.reset();
  const StickState state = stick_state(rig);
  EXPECT_EQ(state.modes(), kBeamModes);
  EXPECT_EQ(state.loss_factor[0], 0.0028);
  EXPECT_EQ(state.loss_factor[2], 0.0011);
  EXPECT_EQ(state.loss_factor.back(), 0.0011) << "later modes take the last value";
  ASSERT_EQ(state.accelerometer.size(), 3U);
  EXPECT_EQ(state.accelerometer[0], state.excitation) << "both at 0.55 m";
}

TEST(StickState, OfModesIsWhatTheRigSays) {
  Rig rig;
  rig.structure = RigModes{{80.0, 200.0}, {0.7, -0.4}, {1.4, 0.3}};
  rig.loss_factor = {0.002};
  rig.excitation.channel = "force";
  rig.accelerometers = {{0.0, {0.5, 0.6}, "acc1"}};
  const StickState state = stick_state(rig, 1);
  EXPECT_EQ(state.modes(), 2U) << "all of them";
  EXPECT_EQ(state.omega, (std::vector{kTurn * 80.0, kTurn * 200.0}));
  EXPECT_EQ(state.excitation, (std::vector{0.7, -0.4}));
  EXPECT_EQ(state.joint, (std::vector{1.4, 0.3}));
  EXPECT_EQ(state.accelerometer[0], (std::vector{0.5, 0.6}));
  EXPECT_EQ(state.loss_factor, (std::vector{0.002, 0.002}));
  EXPECT_TRUE(state.shortening.empty());
  EXPECT_EQ(state.stiffness, 0.0) << "not known";
  EXPECT_EQ(state.axial_compliance, 0.0);
}

TEST(StickState, StickFrequencyGivesTheStiffnessBack) {
  for (const double stiffness : {3e3, 1.7e5, 2e6}) {
    Rig rig = reference_rig();
    rig.contact = {.rod_radius = 0.030, .stiffness = stiffness};
    const double compliance = stick_state(rig).axial_compliance;
    // The frequency that a test shows: of the torsional spring r² k/(1 + k c).
    Rig shown = rig;
    shown.contact.stiffness = stiffness / (1.0 + stiffness * compliance);
    const double frequency = stick_state(shown).omega[0] / kTurn;
    rig.contact = {.rod_radius = 0.030, .stick_frequency = frequency};
    // The frequency changes little with a stiff spring: some digits of k are lost, seven at most.
    EXPECT_NEAR(stick_state(rig).stiffness / stiffness, 1.0, 1e-9) << stiffness;
  }
}

TEST(StickState, RefusesAStickFrequencyThatNoStiffnessGives) {
  const RigBeam beam = *reference_rig().beam();
  const double pinned = first_frequency(beam, kPinned);
  const double clamped = first_frequency(beam, kClamped);
  for (const double frequency : {0.9 * pinned, 1.01 * clamped}) {
    Rig rig = bare_rig(1.0);
    rig.contact = {.rod_radius = 0.030, .stick_frequency = frequency};
    EXPECT_NE(
        message_of<InputError>([&] { return stick_state(rig); }).find("contact.stick_frequency"),
        std::string::npos)
        << frequency;
  }
  // Just below the clamped end: stiffer than the beam is along its axis.
  Rig rig = bare_rig(1.0);
  rig.contact = {.rod_radius = 0.030, .stick_frequency = clamped * (1.0 - 1e-7)};
  EXPECT_NE(message_of<InputError>([&] { return stick_state(rig); }).find("axial compliance alone"),
            std::string::npos);
}

TEST(NaturalFrequency, FallsAsTheJointSoftens) {
  const StickState state = stick_state(reference_rig());
  const double stuck = state.omega[0] / kTurn;
  EXPECT_NEAR(natural_frequency(state, 0.0) / stuck, 1.0, 1e-12);
  double last = stuck;
  for (double softening = 1e4; softening <= 1.6e5; softening += 3e4) {
    const double frequency = natural_frequency(state, softening);
    EXPECT_LT(frequency, last);
    last = frequency;
  }
}

TEST(NaturalFrequency, OfOneModeIsThatOfItsSpring) {
  Rig rig;
  rig.structure = RigModes{{80.0}, {0.7}, {1.4}};
  rig.loss_factor = {0.0};
  rig.excitation.channel = "force";
  rig.accelerometers = {{0.0, {0.7}, "acc1"}};
  const StickState state = stick_state(rig);
  const double square = std::pow(kTurn * 80.0, 2);
  EXPECT_NEAR(natural_frequency(state, 5e3), std::sqrt(square - 5e3 * 1.96) / kTurn, 1e-11);
  EXPECT_EQ(natural_frequency(state, 2.0 * square), 0.0) << "no spring is left";
}

TEST(NaturalFrequency, OfTheBeamWithoutJointIsThatOfThePinnedEnd) {
  // The stuck modes leave out part of the deflection by a moment at L; their share in it falls with
  // i^-2, so that what is left after n of them falls with 1/n.
  const Rig rig = bare_rig(1.7e5);
  const double pinned = first_frequency(*rig.beam(), kPinned);
  const double error_50 = natural_frequency(stick_state(rig, 50), 1.7e5) / pinned - 1.0;
  const double error_100 = natural_frequency(stick_state(rig, 100), 1.7e5) / pinned - 1.0;
  EXPECT_GT(error_100, 0.0) << "a Ritz ansatz lies above";
  EXPECT_LT(error_100, 5e-3);
  EXPECT_NEAR(error_50 / error_100, 2.0, 0.2);
}

}  // namespace
}  // namespace microslip::stick_state_test
