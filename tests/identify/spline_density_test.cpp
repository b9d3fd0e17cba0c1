// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/spline_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip::spline_density_test {
namespace {

/// The joint of the reference rig.
Joint reference_joint() {
  const std::vector<double> force{0, 4, 8, 14, 20, 28, 36, 44, 52, 60, 75};
  std::vector<double> density{20, 17.5, 15, 12.5, 12.5, 15, 16.5, 15.5, 12, 8, 0};
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < force.size(); ++i) {
    area += (force[i + 1] - force[i]) * (density[i] + density[i + 1]) / 2.0;
  }
  for (double& value : density) value /= area;
  return Joint(1.7e5, SlipDensity({PiecewiseLinearPart{force, density}}));
}

/// n levels of equal spacing up to kA = 55 N, D with a relative noise.
Levels noisy_levels(const Joint& joint, int n, double noise, std::uint64_t seed) {
  RandomStream random(seed, 0);
  Levels levels;
  for (int i = 1; i <= n; ++i) {
    const double a = 55.0 / joint.stiffness() * i / n;
    const double d = dissipation(joint, a);
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(d * (1.0 + noise * random.normal()));
    if (noise > 0.0) levels.dissipation_std.push_back(noise * d);
  }
  return levels;
}

/// √(mean square) of φ − truth between 5 N and 50 N, relative to the mean of the truth there.
double error_of(const SignedDensity& result, const Joint& joint) {
  double sum = 0.0;
  double scale = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < result.slip_force.size(); ++i) {
    const double f = result.slip_force[i];
    if (f < 5.0 || f > 50.0) continue;
    const double truth = joint.density().density(f);
    sum += (result.density[i] - truth) * (result.density[i] - truth);
    scale += truth;
    count += 1.0;
  }
  return std::sqrt(sum / count) / (scale / count);
}

// Interpolation of exact values: the error is that of a cubic spline's second derivative, h²/12 of
// the fourth derivative, plus the corners of φ: 1e-3 at 400 levels, and the ends are out of the
// range.
TEST(SplineDensity, FindsTheDensityOfExactLevels) {
  const Joint joint = reference_joint();
  const Levels levels = noisy_levels(joint, 400, 0.0, 0);
  const auto result = density_by_spline(levels, joint.stiffness(), {FixedLambda{0.0}});
  EXPECT_LT(error_of(result.density, joint), 1e-3);
  EXPECT_EQ(result.density.slip_force.size(), 400U);
  EXPECT_EQ(result.density.density.front(), 0.0);
  EXPECT_EQ(result.density.density.back(), 0.0);
  EXPECT_NEAR(result.density_at(30.03), joint.density().density(30.03), 1e-5);
  EXPECT_EQ(result.density_at(56.0), 0.0);
  EXPECT_EQ(result.density_at(0.0), 0.0);
  const auto gcv = density_by_spline(levels, joint.stiffness());
  EXPECT_LT(error_of(gcv.density, joint), 1e-3);
}

// 90 levels with 0.3 % noise, mean of 20 draws: interpolation makes the error nine times the
// density itself, smoothing leaves 0.29 of it. The bounds leave room for another search, not
// another method.
TEST(SplineDensity, SmoothsNoise) {
  const Joint joint = reference_joint();
  double smooth = 0.0;
  double rough = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Levels levels = noisy_levels(joint, 90, 0.003, seed);
    const auto gcv = density_by_spline(levels, joint.stiffness());
    EXPECT_TRUE(gcv.fit.summary.converged());
    smooth += error_of(gcv.density, joint) / 20.0;
    const auto none = density_by_spline(levels, joint.stiffness(), {FixedLambda{0.0}});
    rough += error_of(none.density, joint) / 20.0;
    ASSERT_FALSE(none.warnings.empty());
    EXPECT_EQ(none.warnings.back().code, "density_negative");
  }
  EXPECT_LT(smooth, 0.33);
  EXPECT_GT(rough, 5.0);
}

// p belongs to the unit of A: the same curve from p with A in µm and from its λ in m³.
TEST(SplineDensity, SmoothingFactorWithItsUnit) {
  const Joint joint = reference_joint();
  const Levels levels = noisy_levels(joint, 60, 0.01, 1);
  const double p = 0.003;
  const auto by_p = density_by_spline(levels, joint.stiffness(), {MatlabP{p, 1e-6}});
  const auto by_lambda =
      density_by_spline(levels, joint.stiffness(), {FixedLambda{(1.0 - p) / p * 1e-18}});
  ASSERT_EQ(by_p.density.density.size(), by_lambda.density.density.size());
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_NEAR(by_p.density.density[i], by_lambda.density.density[i], 1e-9);
  }
  EXPECT_NEAR(by_p.fit.lambda, (1.0 - p) / p * 1e-18, 1e-12 * by_p.fit.lambda);
}

// The weights 1/σ² are divided by their mean, so a common factor of σ changes nothing.
TEST(SplineDensity, WeightsAreRelative) {
  const Joint joint = reference_joint();
  Levels levels = noisy_levels(joint, 40, 0.01, 2);
  const FixedLambda lambda{1e-14};
  const auto first = density_by_spline(levels, joint.stiffness(), {lambda});
  double mean = 0.0;
  for (const double sigma : levels.dissipation_std) mean += 1.0 / (sigma * sigma) / 40.0;
  std::vector<double> weight;
  for (const double sigma : levels.dissipation_std) weight.push_back(1.0 / (sigma * sigma) / mean);
  const auto direct = fit_smoothing_spline(levels.amplitude, levels.dissipation, weight, lambda);
  EXPECT_NEAR(first.fit.edf, direct.edf, 1e-9 * direct.edf);
  for (double& sigma : levels.dissipation_std) sigma *= 1e3;
  const auto scaled = density_by_spline(levels, joint.stiffness(), {lambda});
  EXPECT_NEAR(first.fit.edf, scaled.fit.edf, 1e-9 * direct.edf);
  // one σ of 0 cannot be a weight: all count the same
  levels.dissipation_std[3] = 0.0;
  const auto equal = density_by_spline(levels, joint.stiffness(), {lambda});
  levels.dissipation_std.clear();
  const auto none = density_by_spline(levels, joint.stiffness(), {lambda});
  EXPECT_EQ(equal.density.density, none.density.density);
}

TEST(SplineDensity, RefusesWhatItCannotUse) {
  const Joint joint = reference_joint();
  const Levels levels = noisy_levels(joint, 10, 0.0, 0);
  EXPECT_THROW((void)density_by_spline(levels, 0.0), InputError);
  EXPECT_THROW((void)density_by_spline(levels, 1e5, {MatlabP{2.0, 1e-6}}), InputError);
  EXPECT_THROW((void)density_by_spline(noisy_levels(joint, 3, 0.0, 0), 1e5), InputError);
  EXPECT_THROW((void)density_by_spline(noisy_levels(joint, 2, 0.0, 0), 1e5, {FixedLambda{0.0}}),
               InputError);
}

}  // namespace
}  // namespace microslip::spline_density_test
