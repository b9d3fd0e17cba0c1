// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"

namespace microslip::comparison_test {
namespace {

constexpr std::size_t kDraws = 2000;

/// A curve of so many values that measure and prediction put at 10.
ComparedTest test_of(std::size_t values, double measured = 10.0) {
  ComparedCurve curve{.quantity = "force", .dimension = kForce};
  for (std::size_t i = 0; i < values; ++i) curve.at.push_back(static_cast<double>(i));
  curve.measured.assign(values, measured);
  return {.source = "test", .curves = {std::move(curve)}};
}

/// All values of draw i are 10 + σz with one z: an error that they share.
TestPredictor shared_error(std::size_t values, double sigma) {
  return {.nominal = {.values = std::vector<double>(values, 10.0)}, .draw = [=](std::size_t i) {
            RandomStream random(7, i);
            return TestPrediction{.values =
                                      std::vector<double>(values, 10.0 + sigma * random.normal())};
          }};
}

TestDraws draws(std::size_t count = kDraws) { return {.options = {.count = count}}; }

bool warns(const ComparedTest& test, const std::string& code) {
  return std::ranges::count(test.warnings, code, &Warning::code) > 0;
}

// A reading is a draw and its own noise: the band of 95 % lies at ±1.96 √(σ² + σ_m²), its edges
// within four standard deviations of a quantile of 2.5 % of N draws, 2.67/√N of that root.
TEST(TestComparison, BandsHoldDrawsAndNoise) {
  constexpr double kSigma = 0.3;
  constexpr double kNoise = 0.4;
  ComparedTest test = test_of(3);
  test.curves[0].measured_std = {kNoise, kNoise, std::numeric_limits<double>::quiet_NaN()};
  compare(shared_error(3, kSigma), draws(), test);
  const ComparedCurve& curve = test.curves[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const double sigma = i < 2 ? std::hypot(kSigma, kNoise) : kSigma;
    const double tolerance = 4.0 * 2.67 * sigma / std::sqrt(static_cast<double>(kDraws));
    EXPECT_NEAR(curve.lower[i], 10.0 - 1.96 * sigma, tolerance);
    EXPECT_NEAR(curve.upper[i], 10.0 + 1.96 * sigma, tolerance);
  }
  EXPECT_EQ(curve.inside(), 3U);
  EXPECT_TRUE(test.converged());
  EXPECT_FALSE(warns(test, "few_inside"));
}

// σ estimated from 4 degrees of freedom: Student's t, whose 97.5 % lies at 2.776 with a density of
// 0.0256/σ there; within four standard deviations of the quantile of N draws,
// √(0.025·0.975/N)/0.0256. All values of the curve err by one factor of σ, so that the draws know
// of few inside, too.
TEST(TestComparison, BandsHoldWhatAnEstimateMayBeOffBy) {
  constexpr double kNoise = 0.4;
  constexpr std::size_t kValues = 10;
  ComparedTest test = test_of(kValues);
  test.curves[0].measured_std.assign(kValues, kNoise);
  test.curves[0].std_freedom = 4;
  for (std::size_t i = 0; i < kValues / 2; ++i) test.curves[0].measured[i] += 3.0 * kNoise;
  compare(shared_error(kValues, 0.0), draws(), test);
  const ComparedCurve& curve = test.curves[0];
  const double tolerance = 4.0 * 6.1 * kNoise / std::sqrt(static_cast<double>(kDraws));
  EXPECT_NEAR(curve.upper[0], 10.0 + 2.776 * kNoise, tolerance);
  EXPECT_NEAR(curve.lower[0], 10.0 - 2.776 * kNoise, tolerance);
  // Of independent values 5 of 10 outside have a chance of 6e-5.
  EXPECT_EQ(curve.inside(), kValues / 2);
  EXPECT_GT(curve.chance, 0.005);
}

// Ten values that err together lie all inside or all outside of their band. Where they lie outside,
// so do 5 % of the draws, no fewer, however far: that is reported as 5 %, not as 0.05^10, and it is
// as few as the confidence has it.
TEST(TestComparison, ChanceKnowsThatValuesErrTogether) {
  ComparedTest inside = test_of(10, 10.0 + 0.3 * 1.5);
  compare(shared_error(10, 0.3), draws(), inside);
  EXPECT_EQ(inside.curves[0].inside(), 10U);
  EXPECT_EQ(inside.curves[0].chance, 1.0);
  EXPECT_FALSE(warns(inside, "few_inside"));

  ComparedTest outside = test_of(10, 10.0 + 0.3 * 3.0);
  compare(shared_error(10, 0.3), draws(), outside);
  EXPECT_EQ(outside.curves[0].inside(), 0U);
  EXPECT_NEAR(outside.curves[0].chance, 0.05, 0.002);
  EXPECT_TRUE(warns(outside, "few_inside"));
}

// Ten with noise of their own are less often outside: two of ten is common, P = 8.6 % by the
// binomial distribution, within four standard deviations of 2000 draws, 2.5 %; five is not, 6e-5.
TEST(TestComparison, ChanceOfIndependentValuesIsBinomial) {
  const auto with_outside = [](std::size_t count) {
    ComparedTest test = test_of(10);
    test.curves[0].measured_std.assign(10, 0.3);
    for (std::size_t i = 0; i < count; ++i) test.curves[0].measured[i] += 3.0 * 0.3;
    compare(shared_error(10, 0.0), draws(), test);
    EXPECT_EQ(test.curves[0].inside(), 10U - count);
    return test;
  };
  const ComparedTest two = with_outside(2);
  EXPECT_NEAR(two.curves[0].chance, 0.0861, 0.025);
  EXPECT_FALSE(warns(two, "few_inside"));
  const ComparedTest five = with_outside(5);
  EXPECT_LT(five.curves[0].chance, 0.005);
  EXPECT_TRUE(warns(five, "few_inside"));
}

// Five draws beyond each edge of 95 % are 200 draws.
TEST(TestComparison, SaysThatDrawsAreFew) {
  ComparedTest few = test_of(1);
  compare(shared_error(1, 0.3), draws(199), few);
  EXPECT_TRUE(warns(few, "draws_few"));
  ComparedTest enough = test_of(1);
  compare(shared_error(1, 0.3), draws(200), enough);
  EXPECT_FALSE(warns(enough, "draws_few"));
}

TEST(TestComparison, WithoutAValueIsNotConvergedAndHasNoBand) {
  ComparedTest test = test_of(2);
  TestPredictor predictor = shared_error(2, 0.3);
  predictor.nominal.values[1] = std::numeric_limits<double>::quiet_NaN();
  predictor.nominal.failure = "used up";
  compare(predictor, draws(), test);
  EXPECT_FALSE(test.converged());
  EXPECT_TRUE(warns(test, "not_converged"));
  EXPECT_FALSE(test.curves[0].has_band());
  EXPECT_EQ(test.curves[0].compared(), 1U);
}

// More than a tenth of the draws fail: the band is that of the others, and it is said.
TEST(TestComparison, TooManyFailedDrawsAreNotConverged) {
  ComparedTest test = test_of(1);
  TestPredictor predictor = shared_error(1, 0.3);
  const auto whole = predictor.draw;
  predictor.draw = [whole](std::size_t i) {
    TestPrediction drawn = whole(i);
    if (i % 5 == 0) drawn.failure = "no resonance";
    return drawn;
  };
  compare(predictor, draws(), test);
  EXPECT_TRUE(test.curves[0].has_band());
  EXPECT_FALSE(test.converged());
  EXPECT_TRUE(warns(test, "draws_failed"));
}

// rms of 10 % and −10 % is 10 %; of 1 and −1 in units of σ = 2, ½.
TEST(TestComparison, DeviationsAreRootsOfMeanSquares) {
  ComparedCurve curve{.quantity = "force",
                      .dimension = kForce,
                      .at = {0.0, 1.0},
                      .measured = {10.0, 10.0},
                      .measured_std = {2.0, 2.0},
                      .predicted = {11.0, 9.0}};
  EXPECT_NEAR(curve.deviation(), 0.1, 1e-15);
  EXPECT_NEAR(curve.normalised_deviation(), 0.5, 1e-15);
  curve.dimension = kAngle;
  EXPECT_NEAR(curve.deviation(), 1.0, 1e-15);
}

}  // namespace
}  // namespace microslip::comparison_test
