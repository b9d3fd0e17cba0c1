// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/sampled_curves.hpp"

#include <gtest/gtest.h>

#include <cstddef>

#include "microslip/joint/dissipation.hpp"
#include "workflow/results.hpp"

namespace microslip::sampled_curves_test {
namespace {

using test::uniform_joint;

TEST(SampledCurves, EqualRatiosEvenOfOnePoint) {
  const std::vector<double> values = equal_ratios(1.0, 16.0, 5);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(values[i], 1 << i, 1e-14 * values[i]);
  const std::vector<double> about = equal_ratios(3.0, 3.0, 2);
  EXPECT_LT(about.front(), 3.0);
  EXPECT_GT(about.back(), 3.0);
}

// D = 2k²A³/(3·40 N) of the uniform density, by hand.
TEST(SampledCurves, QuantityAndDampingAddUp) {
  const std::vector<double> amplitude = {1e-4, 3e-4};
  const std::vector<double> both = joint_curve(uniform_joint(), dissipation, amplitude, 50.0);
  for (std::size_t i = 0; i < 2; ++i) {
    const double a = amplitude[i];
    EXPECT_NEAR(both[i], 2e10 * a * a * a / 120.0 + 50.0 * a * a, 1e-12 * both[i]);
  }
}

// Φ0 = f*/40 N up to 40 N, all of it beyond.
TEST(SampledCurves, ShareThatSlipsUpToAForce) {
  const Curve share = slipped_share(uniform_joint(), 80.0);
  EXPECT_NEAR(share.y[share.y.size() / 4], 0.5, 1e-12);
  EXPECT_NEAR(share.y.back(), 1.0, 1e-12);
}

// A joint of half the stiffness and half the slip forces: half the force.
TEST(SampledCurves, DifferenceOfLoopsOfOneAmplitude) {
  const Joint half(0.5e5, SlipDensity({UniformPart{.from = 0.0, .to = 20.0, .weight = 1.0}}));
  const SteadyLoop base = steady_loop(uniform_joint(), 3e-4, 10);
  const std::vector<double> apart = force_difference(steady_loop(half, 3e-4, 10), base);
  for (std::size_t i = 0; i < apart.size(); ++i) EXPECT_NEAR(apart[i], -0.5 * base.force[i], 1e-12);
  EXPECT_EQ(loop_amplitudes(4.0), (std::vector{4.0, 3.0, 2.0, 1.0}));
}

}  // namespace
}  // namespace microslip::sampled_curves_test
