// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/joint/dissipation.hpp"
#include "support/structures.hpp"

namespace microslip::damping_ratio_test {
namespace {

constexpr double pi = std::numbers::pi;

const std::vector<double> kResponses{0.01, 0.1, 0.5, 1.0, 2.0, 5.0};

TEST(DampingRatio, IsThatOfTheModeOfALinearStructure) {
  for (const DampingLaw law : {DampingLaw::kViscous, DampingLaw::kHysteretic}) {
    for (const double loss_factor : {0.001, 0.02, 0.5}) {
      const ModalModel linear({{3.0, loss_factor}}, {{"mass", {0.7}}});
      const HarmonicBalance balance(JointedStructure(linear, {}, {{"mass"}}, law), {"mass"});
      const ResponseCurve curve = balance.backbone(kResponses);
      ASSERT_TRUE(curve.summary.converged()) << curve.summary.full();
      for (const SteadyVibration& point : curve.points) {
        // A phase of 1e-12 rad is as much of the frequency; rounding.
        EXPECT_NEAR(point.damping_ratio(), 0.5 * loss_factor, 1e-10 * loss_factor);
      }
    }
  }
}

// In one harmonic an elastic joint adds to the stiffness and nothing else: the damper's ratio is
// that to the resonance as it is.
TEST(DampingRatio, IsThatOfTheStuckStructure) {
  const HarmonicBalance balance(testing::one_mass(Joint(0.25, SlipDensity())), {"mass"});
  for (const SteadyVibration& point : balance.backbone(kResponses).points) {
    EXPECT_NEAR(point.damping_ratio(), 0.005, 1e-12) << "c/(2 sqrt(km)) with k = 1 N/m";
  }
}

// The describing function of the joint: ζ = c/(2mω) + D(a)/(2πmω²a²). 4096 samples leave some 1e-7
// of the dissipation.
TEST(DampingRatio, IsThatOfTheDescribingFunction) {
  for (const Joint& joint : {testing::iwan_joint(), testing::jenkins_joint()}) {
    const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                  {.harmonics = 1, .samples = 4096});
    const ResponseCurve curve = balance.backbone(kResponses);
    ASSERT_TRUE(curve.summary.converged()) << curve.summary.full();
    for (const SteadyVibration& point : curve.points) {
      const double a = point.response;
      const double omega = point.angular_frequency;
      const double expected =
          0.01 / (2.0 * omega) + dissipation(joint, a) / (2.0 * pi * omega * omega * a * a);
      EXPECT_NEAR(point.damping_ratio(), expected, 1e-6 * expected) << a;
    }
  }
}

TEST(DampingRatio, IsZeroWhereNothingMoves) {
  const SteadyVibration still{.angular_frequency = 1.0, .modal = {{0.0, 0.0}}, .joints = {}};
  EXPECT_EQ(still.damping_ratio(), 0.0);
}

}  // namespace
}  // namespace microslip::damping_ratio_test
