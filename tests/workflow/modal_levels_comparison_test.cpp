// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/modal_levels_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/messages.hpp"

namespace microslip::modal_levels_comparison_test {
namespace {

constexpr double kOmega = 500.0;  // rad/s, with the joint stuck
constexpr double kLoss = 0.003;   // of the structure, hysteretic
constexpr double kShape = 0.8;    // kg^-1/2, of mass and joint

const Joint& joint() {
  static const Joint kJoint(1e5, SlipDensity({UniformPart{0.0, 40.0, 0.6}}));
  return kJoint;
}

ModelFile model() {
  return {JointedStructure(ModalModel({{kOmega, kLoss}}, {{"mass", {kShape}}}),
                           {{.name = "lap",
                             .joint = joint(),
                             .shape = {kShape},
                             .spring_in_modes = joint().stiffness()}},
                           {{.point = "mass"}}, DampingLaw::kHysteretic),
          "mass",
          {""}};
}

/// With one harmonic the balance is that of the describing function, in closed form:
///     ω² = ω₀² − φ²(k − k_eq),   ζ = (π η ω₀² A² + φ² D)/(2π ω² A²).
ModalLevels levels() {
  ModalLevels all;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double a : {2e-4, 5e-5, 1e-4}) {  // in no order
    const double square = kShape * kShape;
    const double omega2 =
        kOmega * kOmega - square * (joint().stiffness() - secant_stiffness(joint(), a));
    const double loss = dissipation(joint(), a);
    const double pi = std::numbers::pi;
    all.mode.push_back(0);
    all.displacement.push_back(a);
    all.frequency.push_back(std::sqrt(omega2) / (2.0 * pi));
    all.damping_ratio.push_back((pi * kLoss * kOmega * kOmega * a * a + square * loss) /
                                (2.0 * pi * omega2 * a * a));
    all.dissipation.push_back(all.mode.size() == 2 ? nan : loss);
    all.frequency_std.push_back(1e-3);
    all.damping_ratio_std.push_back(1e-5);
  }
  return all;
}

// Within the error of 256 samples of a cycle, 1e-6 where a density jumps.
TEST(ModalLevelsComparison, IsTheDescribingFunctionWithOneHarmonic) {
  const std::vector<ComparedTest> tests =
      compare_modal_levels("levels.csv", levels(), model(), {.harmonics = 1});
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(tests[0].source, "levels.csv");
  EXPECT_EQ(tests[0].kind, TestKind::kModalLevels);
  EXPECT_TRUE(tests[0].converged());
  ASSERT_EQ(tests[0].curves.size(), 3U);
  for (const ComparedCurve& curve : tests[0].curves) {
    EXPECT_LT(curve.deviation(), 1e-5) << curve.quantity;
    EXPECT_EQ(curve.size(), curve.quantity == "dissipation" ? 2U : 3U);
    EXPECT_TRUE(std::ranges::is_sorted(curve.at));
  }
  EXPECT_LT(tests[0].curves[0].normalised_deviation(), 1.0);
}

// Of a mode that is reduced with a gain of the response by g, its frequency at X is that at X/g.
TEST(ModalLevelsComparison, AGainOfTheResponseMovesTheAmplitude) {
  const ModelFile made = model();
  constexpr double kGain = 0.1;
  const StructureDraws spread(made.structure, {.response_gain = kGain}, {},
                              JointPairing::kIndependent, 1);
  ModalLevels without = levels();
  without.frequency_std.clear();
  without.damping_ratio_std.clear();
  const ComparedTest test = compare_modal_levels("levels.csv", without, made, {.harmonics = 1},
                                                 spread, TestDraws{.options = {.count = 400}})
                                .front();
  const ComparedCurve& damping = test.curves[1];
  const auto ratio_at = [&](double a) {
    const double square = kShape * kShape;
    const double omega2 =
        kOmega * kOmega - square * (joint().stiffness() - secant_stiffness(joint(), a));
    return kLoss * kOmega * kOmega / (2.0 * omega2) +
           square * dissipation(joint(), a) / (2.0 * std::numbers::pi * omega2 * a * a);
  };
  // Edges by the quantiles of the gain, within four standard deviations of them.
  const double slack = 4.0 * 2.67 * kGain / std::sqrt(400.0);
  EXPECT_GT(damping.upper[0], ratio_at(damping.at[0] * std::exp(1.96 * kGain - slack)));
  EXPECT_LT(damping.upper[0], ratio_at(damping.at[0] * std::exp(1.96 * kGain + slack)));
  EXPECT_EQ(damping.inside(), 3U);
}

TEST(ModalLevelsComparison, NeedsAQuantity) {
  ModalLevels bare;
  bare.mode = {0};
  bare.displacement = {1e-4};
  test::expect_message(
      test::message_or("none", [&] { return compare_modal_levels("bare.csv", bare, model(), {}); }),
      "bare.csv = no frequency, damping ratio or dissipation");
}

// Beyond kA of the levels that the joint was identified by.
TEST(ModalLevelsComparison, SaysThatAmplitudesLieBeyondTheIdentification) {
  ModelFile made = model();
  made.covered_to = {joint().stiffness() * 1e-4};
  const ComparedTest test = compare_modal_levels("levels.csv", levels(), made, {}).front();
  EXPECT_EQ(std::ranges::count(test.warnings, "beyond_identification", &Warning::code), 1);
}

}  // namespace
}  // namespace microslip::modal_levels_comparison_test
