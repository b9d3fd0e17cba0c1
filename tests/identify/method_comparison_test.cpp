// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/method_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "microslip/joint/dissipation.hpp"

namespace microslip::method_comparison_test {
namespace {

constexpr double kStiffness = 1.0e5;  // N/m
constexpr double kBeta = 50.0;        // J/m²

/// Of a uniform joint up to 3/4 of its macro-slip, highest first, with a linear damping.
Levels levels_with_damping() {
  const Joint joint(kStiffness, SlipDensity({UniformPart{.from = 0.0, .to = 40.0, .weight = 1.0}}));
  Levels levels;
  for (int i = 20; i >= 1; --i) {
    const double a = 1.5e-5 * i;
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(joint, a) + kBeta * a * a);
  }
  return levels;
}

TEST(MethodComparison, NetLevelsHaveNoLinearDamping) {
  const MethodComparison methods = compare_methods(levels_with_damping(), kStiffness, {}, kBeta);
  EXPECT_TRUE(methods.options.linear_damping);
  ASSERT_EQ(methods.net_evidence.levels().size(), 20);
  for (std::size_t i = 0; i < methods.evidence.levels().size(); ++i) {
    const double a = methods.evidence.levels().amplitude[i];
    EXPECT_NEAR(methods.net_evidence.levels().dissipation[i] + kBeta * a * a,
                methods.evidence.levels().dissipation[i],
                1e-15 * methods.evidence.levels().dissipation[i]);
  }
}

// λ = 1 times the chosen one is the same problem.
TEST(MethodComparison, AFactorOfOneGivesTheSame) {
  const MethodComparison methods = compare_methods(levels_with_damping(), kStiffness, {}, kBeta);
  const InversionResult& chosen = *methods.inversion.inversion();
  const Identification again = inversion_with(methods, 1.0);
  EXPECT_DOUBLE_EQ(again.inversion()->path[again.inversion()->chosen].lambda,
                   chosen.path[chosen.chosen].lambda);
  EXPECT_NEAR(again.inversion()->edf, chosen.edf, 1e-6 * chosen.edf);
  EXPECT_DOUBLE_EQ(spline_with(methods, 1.0).spline()->fit.lambda, methods.spline.fit.lambda);
}

TEST(MethodComparison, MoreSmoothingLeavesFewerDegreesOfFreedom) {
  const MethodComparison methods = compare_methods(levels_with_damping(), kStiffness, {}, kBeta);
  EXPECT_LT(inversion_with(methods, 100.0).inversion()->edf, methods.inversion.inversion()->edf);
  EXPECT_LT(spline_with(methods, 100.0).spline()->fit.edf, methods.spline.fit.edf);
}

}  // namespace
}  // namespace microslip::method_comparison_test
