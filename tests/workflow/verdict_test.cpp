// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "workflow/results.hpp"

namespace microslip::verdict_test {
namespace {

using test::results_with_damping;

bool has(const std::vector<Warning>& warnings, const std::string& code) {
  return std::ranges::find(warnings, code, &Warning::code) != warnings.end();
}

// φ = 0.025 1/N: widths of 0.01, 0.02 and 0.04 1/N inside are half-widths of 20, 40 and 80 %; the
// one below the covered slip forces does not count.
TEST(Verdict, HalfWidthIsTheMedianOverTheCoveredSlipForces) {
  IdentifiedJoint found = *results_with_damping().joint;
  EXPECT_FALSE(typical_half_width(found));
  found.band_slip_force = {1.0, 10.0, 20.0, 30.0};
  found.band_lower = {0.0, 0.02, 0.015, 0.005};
  found.band_upper = {9.0, 0.03, 0.035, 0.045};
  EXPECT_NEAR(typical_half_width(found).value(), 0.4, 1e-12);
}

// 3, 4 and 5 %; what scatters less than its noise has no error that can be seen.
TEST(Verdict, BeyondNoiseIsTheRestOfTheSquares) {
  EXPECT_NEAR(beyond_noise({.nrmse = 0.05, .noise_share = 0.03}), 0.04, 1e-15);
  EXPECT_EQ(beyond_noise({.nrmse = 0.03, .noise_share = 0.05}), 0.0);
}

TEST(Verdict, ErrorAgainstTheTruth) {
  ExperimentResults results = results_with_damping();
  EXPECT_FALSE(error_against_truth(results));
  results.truth = test::uniform_joint();
  EXPECT_NEAR(error_against_truth(results).value(), 0.0, 1e-12);
}

TEST(Verdict, AJointThatMissesTheLevelsIsTold) {
  ExperimentResults results = results_with_damping();
  EXPECT_FALSE(has(warnings_of(results, {}), "joint_misses_levels"));
  Levels& levels = results.levels->levels;
  for (const double d : levels.dissipation) levels.dissipation_std.push_back(0.01 * d);
  EXPECT_FALSE(has(warnings_of(results, {}), "joint_misses_levels"));
  for (double& d : levels.dissipation) d *= 1.1;  // ten times the standard deviation
  EXPECT_TRUE(has(warnings_of(results, {}), "joint_misses_levels"));
}

TEST(Verdict, EachCodeOnceAndFirstThatOfTheFiles) {
  ExperimentResults results = results_with_damping();
  results.warnings = {{"levels_flagged", "as the file says"}};
  results.levels->flags = {"spike", "", "", ""};
  results.comparisons = {{.source = "a", .channel = "force", .status = "not converged"},
                         {.source = "a", .channel = "acc1", .status = "not converged"}};
  const std::vector<Warning> warnings = warnings_of(results, {});
  EXPECT_EQ(std::ranges::count(warnings, "levels_flagged", &Warning::code), 1);
  EXPECT_EQ(warnings.front().text, "as the file says");
  EXPECT_TRUE(has(warnings, "prediction_not_converged"));
  EXPECT_TRUE(has(warnings, "joint_of_unknown_origin"));
}

// What the levels do not show again, as the effect of a torque, is said in the words of the file.
TEST(Verdict, SaysWhatTheIdentificationSaid) {
  ExperimentResults results = results_with_damping();
  results.joint->warnings = {"conditions_pooled"};
  results.joint->warning_texts = {"tests at two torques are identified together"};
  const std::vector<Warning> warnings = warnings_of(results, {});
  const auto found = std::ranges::find(warnings, "conditions_pooled", &Warning::code);
  ASSERT_NE(found, warnings.end());
  EXPECT_EQ(found->text, "tests at two torques are identified together");
}

}  // namespace
}  // namespace microslip::verdict_test
