// SPDX-License-Identifier: MIT
#include "microslip/dynamics/truncation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/structures.hpp"
#include "microslip/dynamics/harmonic_balance.hpp"
#include "support/figures.hpp"

namespace microslip {
namespace {

/// The third harmonic of the slipping joint drives the second mode: its motion is far from a sine.
JointedStructure slipping() {
  const ModalModel linear({{1.0, 0.01}, {2.6, 0.01}}, {{"a", {1.0, 0.8}}});
  return JointedStructure(linear, {{"joint", testing::jenkins_joint(), {1.0, 1.0}}}, {{"a"}});
}

HarmonicBalance balance_with(std::size_t harmonics) {
  return {slipping(), {"a"}, {.harmonics = harmonics, .samples = 1024}};
}

const std::vector<double> kResponses{1.0, 1.5, 2.0, 3.0};

// What is said to change is the error, against 41 harmonics, but for a part: it is found with 2H + 1.
TEST(Truncation, IsTheErrorOfTheDissipation) {
  const ResponseCurve truth = balance_with(41).resonances(kResponses);
  ASSERT_TRUE(truth.summary.converged());
  for (const std::size_t harmonics : {1U, 3U, 5U, 9U}) {
    const HarmonicBalance balance = balance_with(harmonics);
    const ResponseCurve curve = balance.resonances(kResponses);
    ASSERT_EQ(curve.points.size(), truth.points.size());
    double error = 0.0;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      error = std::max(error, std::abs(curve.points[i].joints[0].dissipation /
                                           truth.points[i].joints[0].dissipation -
                                       1.0));
    }
    const auto found = judge_truncation(balance, curve, Quantity::kPhaseLag);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->harmonics, 2 * harmonics + 1);
    EXPECT_GE(found->points, 2U);
    EXPECT_GE(found->dissipation, 0.3 * error) << harmonics;
    EXPECT_LE(found->dissipation, 1.7 * error) << harmonics;
    const std::optional<Warning> warning = truncation_warning(*found);
    EXPECT_EQ(warning.has_value(), found->largest() > kTruncationAllowed) << harmonics;
    if (harmonics == 1) {
      ASSERT_TRUE(warning.has_value());
      EXPECT_EQ(warning->code, "truncated");
      EXPECT_NE(warning->text.find("take 3 harmonics"), std::string::npos) << warning->text;
    }
  }
}

// At constant force and at constant response, where peaks and the largest motions are looked at.
TEST(Truncation, IsJudgedOnFrequencyResponses) {
  for (const std::size_t harmonics : {1U, 9U}) {
    const HarmonicBalance balance = balance_with(harmonics);
    const auto force = judge_truncation(balance, balance.frequency_response(0.1, 0.8, 1.3),
                                        Quantity::kForceAmplitude);
    const auto response =
        judge_truncation(balance, balance.constant_response(1.5, 0.9, 1.2), Quantity::kResponse);
    ASSERT_TRUE(force && response);
    EXPECT_FALSE(force->unsolved || response->unsolved);
    EXPECT_EQ(truncation_warning(*force).has_value(), harmonics == 1);
    EXPECT_EQ(truncation_warning(*response).has_value(), harmonics == 1);
  }
}

// Where the joint sticks there is nothing above the first harmonic.
TEST(Truncation, IsNoneWhereNothingSlips) {
  const HarmonicBalance balance = balance_with(1);
  const ResponseCurve curve = balance.frequency_response(1e-4, 0.8, 1.3);
  const auto found = judge_truncation(balance, curve, Quantity::kForceAmplitude);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->largest(), 1e-9);
  EXPECT_FALSE(truncation_warning(*found).has_value());
  const JointedStructure linear(slipping().linear(), {}, {{"a"}});
  EXPECT_FALSE(judge_truncation(HarmonicBalance(linear, {"a"}), curve, Quantity::kForceAmplitude)
                   .has_value());
}

TEST(Truncation, SaysWhereItCouldNotBeSeen) {
  Truncation truncation;
  truncation.harmonics = 11;
  truncation.unsolved = "a reason";
  const auto warning = truncation_warning(truncation);
  ASSERT_TRUE(warning.has_value());
  EXPECT_EQ(warning->code, "truncation_unknown");
  EXPECT_NE(warning->text.find("a reason"), std::string::npos);
}

}  // namespace
}  // namespace microslip
