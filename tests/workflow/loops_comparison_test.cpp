// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/loops_comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "support/force_records.hpp"
#include "support/messages.hpp"

namespace microslip::loops_comparison_test {
namespace {

const Joint& joint() {
  static const Joint kJoint(1.7e5, SlipDensity({UniformPart{0.0, 40.0, 0.6}}));
  return kJoint;
}

/// On a random path, whose cycles have many amplitudes.
NamedForceRecord record(const testing::RecordNoise& noise = {}) {
  const std::vector<double> path = testing::random_motion(3000, 2.4e-4, 3);
  return {"record.csv", testing::simulated_record(joint(), path, 3, noise)};
}

const ComparedCurve& curve(const ComparedTest& test, const std::string& quantity) {
  return *std::ranges::find(test.curves, quantity, &ComparedCurve::quantity);
}

bool warns(const ComparedTest& test, const std::string& code) {
  return std::ranges::count(test.warnings, code, &Warning::code) > 0;
}

// By the joint that made it what is left is noise: of the force, 0.4 % of its largest, and of the
// path, 2e-4 of its largest, which a stiff joint turns into force: some 1.5 of the noise of the
// force. Losses of cycles differ by their standard deviations: near 1, the mean of a few dozen,
// below 2.
TEST(LoopsComparison, OfTheTrueJointLeavesNoise) {
  const ComparedTest test = compare_loops(record(), {joint()});
  EXPECT_EQ(test.kind, TestKind::kLoops);
  const double noise = curve(test, "force_noise").predicted[0];
  const double nrmse = curve(test, "force_nrmse").predicted[0];
  EXPECT_GT(nrmse, 0.5 * noise);
  EXPECT_LT(nrmse, 2.0 * noise);
  EXPECT_GE(curve(test, "dissipation").size(), 5U);
  EXPECT_LT(curve(test, "dissipation").normalised_deviation(), 2.0);
  EXPECT_TRUE(test.converged());
  EXPECT_FALSE(warns(test, "test_not_of_this_kind"));
}

// A joint under half of its load reaches half of the force where it slips; the loss is another,
// too.
TEST(LoopsComparison, TellsAnotherJoint) {
  const Joint half(1.7e5, SlipDensity({UniformPart{0.0, 20.0, 0.6}}));
  const ComparedTest test = compare_loops(record(), {half});
  EXPECT_GT(curve(test, "force_nrmse").predicted[0],
            10.0 * curve(test, "force_noise").predicted[0]);
  EXPECT_GT(curve(test, "dissipation").normalised_deviation(), 10.0);
}

// βA² and cπωA² add to D of each cycle and to nothing of the rest; forces have no β.
TEST(LoopsComparison, AddsLinearAndViscousLosses) {
  constexpr double kBeta = 5000.0;
  const ComparedTest without = compare_loops(record(), {joint()});
  const ComparedTest damped = compare_loops(record(), {joint(), kBeta});
  const ComparedCurve& d = curve(damped, "dissipation");
  for (std::size_t i = 0; i < d.size(); ++i) {
    EXPECT_NEAR(d.predicted[i] - curve(without, "dissipation").predicted[i],
                kBeta * d.at[i] * d.at[i], 1e-9 * d.predicted[i]);
  }
  EXPECT_EQ(curve(damped, "force_nrmse").predicted, curve(without, "force_nrmse").predicted);
  EXPECT_TRUE(warns(damped, "linear_damping_left_out"));
  EXPECT_GT(curve(compare_loops(record(), {joint(), 0.0, 100.0}), "dissipation").predicted[0],
            curve(without, "dissipation").predicted[0]);
}

// Draws of the load, by themselves, about the true one.
TEST(LoopsComparison, BandsOfDrawsHoldTheLosses) {
  const auto draw = [](std::size_t i) {
    const double load = 0.9 + 0.2 * static_cast<double>(i) / 99.0;
    return LoopJoint{Joint(1.7e5, SlipDensity({UniformPart{0.0, 40.0 * load, 0.6}}))};
  };
  const ComparedTest test =
      compare_loops(record(), {joint()}, draw, TestDraws{.options = {.count = 100}});
  const ComparedCurve& d = curve(test, "dissipation");
  EXPECT_GE(d.inside(), d.size() - 1);
  EXPECT_FALSE(std::isfinite(curve(test, "force_nrmse").measured[0]));
  EXPECT_LT(curve(test, "force_nrmse").lower[0], curve(test, "force_nrmse").upper[0]);
}

TEST(LoopsComparison, SaysWhatARecordIsNot) {
  LoopJoint known{joint()};
  known.covered_to = 1.0;
  EXPECT_TRUE(warns(compare_loops(record(), known), "beyond_identification"));

  NamedForceRecord gap = record({.displacement = 0.0});
  for (std::size_t i = 0; i < gap.record.size(); ++i) {  // backlash of a third of the path
    double& u = gap.record.displacement[i];
    u += u > 0.0 ? 8e-5 : -8e-5;
  }
  const ComparedTest departed = compare_loops(gap, {joint()});
  EXPECT_TRUE(warns(departed, "test_not_of_this_kind"));

  NamedForceRecord rising{"rising.csv", {}};
  for (int i = 0; i < 100; ++i) {
    rising.record.displacement.push_back(1e-6 * i);
    rising.record.force.push_back(0.1 * i);
  }
  rising.record.time_step = 0.01;
  test::expect_message(test::message_or("none", [&] { return compare_loops(rising, {joint()}); }),
                       "rising.csv: displacement");
}

}  // namespace
}  // namespace microslip::loops_comparison_test
