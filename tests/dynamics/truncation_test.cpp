// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/truncation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/figures.hpp"
#include "support/structures.hpp"

namespace microslip::truncation_test {
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

// The estimated change is the error, against 41 harmonics, but for a part: it is found with 2H + 1.
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

// At constant force and at constant response, where peaks and the largest motions are examined.
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

/// Superharmonic resonances of both modes, those of harmonics above 5 among them.
HarmonicBalance with_many_peaks(std::size_t harmonics) {
  constexpr double kHertz = 6.283185307179586;
  const ModalModel linear({{kHertz * 10.0, 0.002}, {kHertz * 80.0, 0.002}, {kHertz * 400.0, 0.002}},
                          {{"a", {1.0, -1.0, 1.0}}});
  const Joint joint(1e5, SlipDensity({UniformPart{0.0, 50.0, 1.0}}));
  return {JointedStructure(linear, {{"joint", joint, {1.0, 0.8, 0.6}}}, {{"a"}}),
          {"a"},
          {.harmonics = harmonics, .samples = 512}};
}

// Some peak far from the largest is wrong by more than all others: none is left out, none counts
// twice.
TEST(Truncation, IsSeenAtEachPeak) {
  constexpr double kHertz = 6.283185307179586;
  const HarmonicBalance balance = with_many_peaks(5);
  const HarmonicBalance fine = with_many_peaks(23);
  const ResponseCurve curve = balance.frequency_response(20.0, kHertz * 1000.0, kHertz * 5.0);
  ASSERT_GE(curve.peaks.size(), 6U);
  double error = 0.0;
  for (const SteadyVibration& peak : curve.peaks) {
    SteadyVibration start = peak;
    for (JointCycle& joint : start.joints) joint.displacement.resize(24);
    const VibrationResult exact =
        fine.solve({Quantity::kAngularFrequency, peak.angular_frequency},
                   {Quantity::kForceAmplitude, peak.force_amplitude}, start);
    ASSERT_TRUE(exact.summary.converged()) << exact.summary.full();
    error = std::max(
        error, std::abs(peak.joints[0].dissipation / exact.vibration.joints[0].dissipation - 1.0));
  }
  EXPECT_GT(error, 0.01);
  const auto found = judge_truncation(balance, curve, Quantity::kForceAmplitude);
  ASSERT_TRUE(found.has_value());
  EXPECT_GE(found->points, curve.peaks.size());
  EXPECT_LE(found->points, curve.peaks.size() + 3);  // largest joint, damping, highest harmonics
  EXPECT_EQ(found->peaks_left_out, 0U);
  EXPECT_GE(found->dissipation, 0.8 * error);
  ASSERT_TRUE(truncation_warning(*found).has_value());
  EXPECT_EQ(truncation_warning(*found)->code, "truncated");
}

// What is one point is solved once: the only peak has the largest response and joint motion as
// well.
TEST(Truncation, SolvesNoPointTwice) {
  const HarmonicBalance balance = balance_with(3);
  ResponseCurve curve = balance.frequency_response(0.1, 0.9, 1.2);
  ASSERT_EQ(curve.peaks.size(), 1U);
  curve.points = curve.peaks;
  curve.peak_points = {0};
  const auto found = judge_truncation(balance, curve, Quantity::kForceAmplitude);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->points, 1U);
}

TEST(Truncation, SaysHowManyPeaksWereLeftOut) {
  const HarmonicBalance balance = balance_with(3);
  ResponseCurve curve = balance.frequency_response(0.1, 0.9, 1.2);
  ASSERT_GE(curve.points.size(), 30U);
  curve.turning_points.clear();
  curve.peak_points.clear();
  for (std::size_t i = 0; i < 30; ++i) curve.peak_points.push_back(i);
  const auto found = judge_truncation(balance, curve, Quantity::kForceAmplitude);
  ASSERT_TRUE(found.has_value());
  EXPECT_GE(found->points, 20U);
  EXPECT_GE(found->peaks_left_out, 30U - found->points);
  EXPECT_LE(found->peaks_left_out, 10U);
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
}  // namespace microslip::truncation_test
