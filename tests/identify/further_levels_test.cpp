// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/further_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"

namespace microslip::further_levels_test {
namespace {

using testing::kStiffness;

struct Known {
  LevelEvidence evidence;
  InversionResult result;
  std::vector<Joint> joints;
};

Known known(const Levels& levels) {
  LevelEvidence evidence(levels);
  InversionResult result = invert(evidence, kStiffness);
  const std::vector<DensitySample> samples = result.posterior.samples(1, 50);
  std::vector<Joint> joints = drawn_joints(result, samples, kStiffness);
  return {std::move(evidence), std::move(result), std::move(joints)};
}

Levels levels_of(std::size_t count) {
  Levels levels = testing::levels_at(testing::reference_joint(), testing::equal_steps(count));
  testing::add_noise(levels, 0.01, 5);
  return levels;
}

// Without deviations a level has the relative scatter of D that was found, 1 % to the third that 20
// levels determine it; with them, the given one at that amplitude: here 1 % below and 4 % above.
TEST(FurtherLevels, HaveTheNoiseOfTheLevels) {
  const std::vector<double> at{5e-5, 1e-4, 2.5e-4};
  Levels levels = levels_of(40);
  const Known plain = known(levels);
  const FurtherLevels further = further_levels(plain.evidence, plain.result, plain.joints, at);
  for (std::size_t c = 0; c < at.size(); ++c) {
    const double d = dissipation(testing::reference_joint(), at[c]);
    EXPECT_NEAR(further.dissipation_std[c] / d, plain.result.dissipation_scatter, 1e-3);
    EXPECT_NEAR(further.dissipation_std[c] / d, 0.01, 0.004);
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels.dissipation_std.push_back((levels.amplitude[i] < 1.5e-4 ? 0.01 : 0.04) *
                                     levels.dissipation[i]);
  }
  const Known given = known(levels);
  const FurtherLevels weighted = further_levels(given.evidence, given.result, given.joints, at);
  EXPECT_NEAR(weighted.dissipation_std[2] / weighted.dissipation_std[1] /
                  (dissipation(testing::reference_joint(), at[2]) /
                   dissipation(testing::reference_joint(), at[1])),
              4.0, 0.3);
}

// Levels measured twice are known to 1/√2 of the deviation; a further one is not.
TEST(FurtherLevels, AreSingleOnes) {
  Levels levels = levels_of(30);
  for (std::size_t i = 0; i < 30; ++i) {
    levels.dissipation_std.push_back(0.01 * levels.dissipation[i]);
  }
  Levels twice = levels;
  for (std::size_t i = 0; i < 30; ++i) {
    twice.amplitude.push_back(levels.amplitude[i]);
    twice.dissipation.push_back(levels.dissipation[i]);
    twice.dissipation_std.push_back(levels.dissipation_std[i]);
  }
  const std::vector<double> at{1e-4};
  const Known one = known(levels);
  const Known two = known(twice);
  const double once = further_levels(one.evidence, one.result, one.joints, at).dissipation_std[0] /
                      one.result.dissipation_scatter;
  const double repeated =
      further_levels(two.evidence, two.result, two.joints, at).dissipation_std[0] /
      two.result.dissipation_scatter;
  EXPECT_NEAR(repeated / once, 1.0, 0.02);
}

TEST(FurtherLevels, OfTheSecantStiffnessAreLessTheMean) {
  Levels levels = levels_of(30);
  testing::add_secant(testing::reference_joint(), 1e-3, 3, levels);
  levels.secant_stiffness_std.assign(30, 100.0);
  const Known all = known(levels);
  const FurtherLevels further = further_levels(all.evidence, all.result, all.joints, {1e-4, 2e-4});
  ASSERT_EQ(further.secant_stiffness.rows(), all.joints.size());
  for (std::size_t i = 0; i < all.joints.size(); ++i) {
    double mean = 0.0;
    for (const double a : levels.amplitude) mean += secant_stiffness(all.joints[i], a) / 30.0;
    EXPECT_NEAR(further.secant_stiffness.values[2 * i],
                secant_stiffness(all.joints[i], 1e-4) - mean, 1e-6 * kStiffness);
  }
  EXPECT_NEAR(further.secant_offset_std, further.secant_stiffness_std[0] / std::sqrt(30.0), 1e-6);
}

// Beyond the levels draws are wider, but by the prior as smooth as they are below; within, they are
// unchanged: nothing was measured. To a half, which is the effect of another basis, given
// deviations and 300 draws of which a fifth are independent.
TEST(FurtherLevels, ReachBeyondTheLevels) {
  const LevelEvidence evidence(levels_of(40));
  const InversionResult result = invert(evidence, kStiffness);
  const LevelEvidence far = reaching_to(evidence, result, kStiffness, 4e-4);
  const InversionResult beyond = invert(far, kStiffness);
  const auto width = [&](const InversionResult& found, double f) {
    const std::vector<Joint> joints =
        drawn_joints(found, found.posterior.samples(1, 300), kStiffness);
    double mean = 0.0;
    double square = 0.0;
    for (const Joint& joint : joints) {
      mean += joint.density().density(f) / 300.0;
      square += joint.density().density(f) * joint.density().density(f) / 300.0;
    }
    return std::sqrt(square - mean * mean);
  };
  EXPECT_NEAR(width(beyond, 20.0) / width(result, 20.0), 1.0, 0.5);
  EXPECT_GT(width(beyond, 62.0), 1.5 * width(beyond, 40.0));
  EXPECT_THROW((void)reaching_to(evidence, result, kStiffness, 2e-4), InputError);
}

TEST(FurtherLevels, TargetsAreTheDensityAndItsArea) {
  const std::vector<Joint> joints{testing::joint_of({UniformPart{0, 40, 0.8}}),
                                  testing::joint_of({UniformPart{0, 20, 0.4}})};
  const DesignTarget area = area_target(joints, {10.0, 30.0});
  EXPECT_NEAR(area.draws.values[0], 0.4, 1e-12);
  EXPECT_NEAR(area.draws.values[1], 0.2, 1e-12);
  const DesignTarget density = density_target(joints, {10.0, 30.0});
  ASSERT_EQ(density.draws.rows(), 2U);
  double sum = 0.0;
  for (std::size_t i = 0; i < density.weight.size(); ++i) {
    EXPECT_NEAR(density.draws.values[i], 0.02, 1e-12);
    sum += density.weight[i];
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(density.draws.values.back(), 0.0);
}

}  // namespace
}  // namespace microslip::further_levels_test
