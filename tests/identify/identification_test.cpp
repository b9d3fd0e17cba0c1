// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/identification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/densities.hpp"

namespace microslip::identification_test {
namespace {

using testing::kStiffness;

IdentificationOptions options_for(IdentificationMethod method = IdentificationMethod::kInversion) {
  IdentificationOptions options;
  options.method = method;
  return options;
}

bool has(const Identification& found, std::string_view code) {
  return std::ranges::any_of(found.warnings, [&](const Warning& w) { return w.code == code; });
}

TEST(Identification, MethodNames) {
  EXPECT_EQ(to_string(IdentificationMethod::kInversion), "inversion");
  EXPECT_EQ(to_string(IdentificationMethod::kSpline), "spline");
  EXPECT_EQ(to_string(IdentificationMethod::kDifferences), "differences");
}

// The joint has the density found, to rounding of the interpolation; D of the joint is D of the
// levels to the scatter of 1 %.
TEST(Identification, JointOfAnInversion) {
  const Joint truth = testing::reference_joint();
  Levels levels = testing::noisy_levels(truth, 1);
  std::ranges::reverse(levels.amplitude);
  std::ranges::reverse(levels.dissipation);
  IdentificationOptions options = options_for();
  options.bands.emplace();
  options.bands->samples = 50;
  options.bands->confidence = 0.9;
  options.bands->seed = 3;
  const Identification found = identify(levels, kStiffness, options);
  EXPECT_EQ(found.method, IdentificationMethod::kInversion);
  EXPECT_TRUE(found.summary.converged());
  EXPECT_TRUE(found.warnings.empty()) << found.warnings.front().text;
  EXPECT_EQ(found.joint.stiffness(), kStiffness);
  EXPECT_DOUBLE_EQ(found.covered_from, kStiffness * testing::kLowestAmplitude);
  EXPECT_DOUBLE_EQ(found.covered_to, testing::kReach);
  ASSERT_TRUE(found.inversion() != nullptr);
  EXPECT_EQ(found.slip_force, found.inversion()->slip_force);
  EXPECT_EQ(found.density, found.inversion()->density);
  for (const double f : {1.0, 7.7, 33.0, 50.0}) {
    EXPECT_NEAR(found.joint.density().density(f),
                testing::density_at(found.slip_force, found.density, f), 1e-14);
  }
  EXPECT_NEAR(found.joint.density().total().zeroth, found.inversion()->area, 1e-12);
  for (const double a : {3e-5, 1e-4, 3e-4}) {
    EXPECT_NEAR(dissipation(found.joint, a) / dissipation(truth, a), 1.0, 0.01);
  }
  ASSERT_TRUE(found.bands() != nullptr);
  EXPECT_EQ(found.lower, found.bands()->lower);
  EXPECT_EQ(found.upper, found.bands()->upper);
  EXPECT_EQ(found.bands()->confidence, 0.9);
  EXPECT_FALSE(found.linear_damping.has_value());
  EXPECT_FALSE(found.spline() || found.differences() || found.parametric);
}

TEST(Identification, AtomAndDamping) {
  const Joint truth = Joint::four_parameter(17.5, kStiffness, -0.5, 1.0 / 3.0);
  IdentificationOptions options = options_for();
  options.inversion.atom = true;
  options.inversion.linear_damping = true;
  const Identification found = identify(testing::noisy_levels(truth, 2), kStiffness, options);
  ASSERT_EQ(found.joint.density().atoms().slip_force.size(), 1U);
  EXPECT_NEAR(found.joint.density().atoms().slip_force[0], 35.0,
              0.7);  // 2 %, see the inversion's test
  EXPECT_NEAR(found.joint.density().atoms().weight[0], 0.25, 0.05);
  EXPECT_NEAR(found.joint.density().total().zeroth, found.inversion()->area, 1e-9);
  ASSERT_TRUE(found.linear_damping.has_value());
  EXPECT_GE(*found.linear_damping, 0.0);
}

// Differences of noisy data are mostly noise: the joint is that with the negative half clipped and
// the area scaled to 1, and both give a warning.
TEST(Identification, DifferencesAreMadeFeasible) {
  const Identification found =
      identify(testing::noisy_levels(testing::reference_joint(), 3), kStiffness,
               options_for(IdentificationMethod::kDifferences));
  EXPECT_TRUE(has(found, "density_clipped"));
  EXPECT_TRUE(has(found, "density_scaled"));
  EXPECT_NEAR(found.joint.density().total().zeroth, 1.0, 1e-9);
  EXPECT_GE(*std::ranges::min_element(found.density), 0.0);  // the density is that of the joint …
  ASSERT_TRUE(found.differences() != nullptr);               // … and the original result is kept
  EXPECT_LT(*std::ranges::min_element(found.differences()->density), 0.0);
  EXPECT_TRUE(found.summary.converged());
  const Levels three = testing::levels_at(testing::reference_joint(), {1e-5, 1e-4, 3e-4});
  EXPECT_THROW((void)identify(three, kStiffness, options_for(IdentificationMethod::kDifferences)),
               InputError);
}

TEST(Identification, Spline) {
  const Joint truth = testing::reference_joint();
  const Identification found = identify(testing::noisy_levels(truth, 4), kStiffness,
                                        options_for(IdentificationMethod::kSpline));
  ASSERT_TRUE(found.spline() != nullptr);
  EXPECT_LE(found.joint.density().total().zeroth, 1.0 + 1e-9);
  EXPECT_EQ(found.slip_force, found.spline()->density.slip_force);
  EXPECT_NEAR(dissipation(found.joint, 2e-4) / dissipation(truth, 2e-4), 1.0, 0.1);
}

// A parametric model replaces the joint and the density for plots; the result of the inversion
// stays.
TEST(Identification, ParametricFit) {
  const Joint truth = Joint::four_parameter(17.5, kStiffness, -0.5, 1.0 / 3.0);
  IdentificationOptions options = options_for();
  options.fit = ParametricModel::kFourParameter;
  const Identification found = identify(testing::noisy_levels(truth, 5), kStiffness, options);
  ASSERT_TRUE(found.parametric.has_value());
  EXPECT_TRUE(found.inversion() != nullptr);
  EXPECT_EQ(found.slip_force.size(), 400U);
  EXPECT_EQ(found.slip_force.size(), found.density.size());
  EXPECT_TRUE(found.lower.empty());
  EXPECT_TRUE(std::ranges::all_of(found.density, [](double v) { return std::isfinite(v); }));
  EXPECT_NEAR(found.joint.macroslip_force(), 17.5, 0.02 * 17.5);  // straight-line D: f_y to ~0.3 %
}

TEST(Identification, BandsNeedTheInversion) {
  IdentificationOptions options = options_for(IdentificationMethod::kSpline);
  options.bands = BandOptions{};
  try {
    (void)identify(testing::exact_levels(testing::reference_joint()), kStiffness, options);
    FAIL() << "bands of a spline were accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "bands = asked for; come with the method inversion only. Leave out the method, or "
                 "the bands.");
  }
}

// The band of the free density would be taken for one of the model.
TEST(Identification, BandsNeedTheFreeDensity) {
  IdentificationOptions options = options_for();
  options.fit = ParametricModel::kPowerLaw;
  options.bands = BandOptions{};
  try {
    (void)identify(testing::exact_levels(testing::reference_joint()), kStiffness, options);
    FAIL() << "bands beside a model were accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "bands = asked for; are those of a free density, not of the model power_law. Leave "
        "out the model, whose parameters have standard errors, or the bands.");
  }
}

// k_eq and frequencies judge the joint that is given, whatever the method: here that of a model
// with a k that is 26 % too large.
TEST(Identification, StiffnessJudgesTheJointOfEachMethod) {
  const Joint truth = testing::joint_of({UniformPart{0.0, 40.0, 0.5}});
  Levels levels = testing::exact_levels(truth);
  for (const double a : levels.amplitude) {
    levels.frequency.push_back(80.0 * (1.0 + 0.01 * a / levels.amplitude.back()));
    levels.secant_stiffness.push_back(secant_stiffness(truth, a) - 0.26 * kStiffness);
    levels.secant_stiffness_std.push_back(2e-3 * kStiffness);
  }
  for (const auto method : {IdentificationMethod::kInversion, IdentificationMethod::kSpline,
                            IdentificationMethod::kDifferences}) {
    const Identification found = identify(levels, kStiffness, options_for(method));
    EXPECT_TRUE(has(found, "frequency_rises")) << to_string(method);
    EXPECT_EQ(std::ranges::count(found.warnings, "secant_inconsistent", &Warning::code), 1)
        << to_string(method);
    ASSERT_TRUE(found.stiffness.secant && found.stiffness.frequency);
    EXPECT_NEAR(found.stiffness.secant->offset / kStiffness, -0.26, 0.02) << to_string(method);
  }
  IdentificationOptions fit = options_for();
  fit.fit = ParametricModel::kUniform;
  const Identification model = identify(levels, kStiffness, fit);
  EXPECT_TRUE(has(model, "frequency_rises"));
}

TEST(Identification, WarningsOfLevelsComeFirst) {
  Levels levels = testing::levels_at(testing::power_law(), testing::equal_ratios(9, 1e-4, 3e-4));
  levels.amplitude.push_back(levels.amplitude.back());
  levels.dissipation.push_back(levels.dissipation.back());
  const Identification found = identify(levels, kStiffness, options_for());
  ASSERT_GE(found.warnings.size(), 3U);
  EXPECT_EQ(found.warnings[0].code, "few_levels");
  EXPECT_EQ(found.warnings[1].code, "amplitudes_merged");
  EXPECT_TRUE(has(found, "extrapolation"));
}

TEST(Identification, InputErrors) {
  EXPECT_THROW((void)identify(Levels{}, kStiffness, options_for()), InputError);
  const Levels levels = testing::exact_levels(testing::reference_joint());
  for (const auto method : {IdentificationMethod::kInversion, IdentificationMethod::kSpline,
                            IdentificationMethod::kDifferences}) {
    EXPECT_THROW((void)identify(levels, -1.0, options_for(method)), InputError);
  }
}

}  // namespace
}  // namespace microslip::identification_test
