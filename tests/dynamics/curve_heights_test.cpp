// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/curve_heights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/structures.hpp"

namespace microslip::curve_heights_test {
namespace {

/// The largest miss of a coarse curve at the points of a fine one, over the highest.
double largest_miss(const JointedStructure& structure, const Target& kept, double from, double to) {
  HarmonicBalanceOptions options{.harmonics = 3, .samples = 128, .accuracy = 0.0};
  const ResponseCurve coarse = HarmonicBalance(structure, {"mass"}, options)
                                   .follow(kept, Quantity::kAngularFrequency, from, to);
  options.accuracy = 2e-4;
  const ResponseCurve fine = HarmonicBalance(structure, {"mass"}, options)
                                 .follow(kept, Quantity::kAngularFrequency, from, to);
  const CurveHeights heights(coarse, kept.quantity);
  double highest = 0.0;
  double miss = 0.0;
  for (const SteadyVibration& point : fine.points) {
    const double expected = height_of(point, kept.quantity);
    double least = HUGE_VAL;
    for (const double h : heights.at(point.angular_frequency)) {
      least = std::min(least, std::abs(h - expected));
    }
    highest = std::max(highest, expected);
    miss = std::max(miss, least);
  }
  return miss / highest;
}

// The error that the class states, 1e-3; between steps of 20 % straight lines lie 1e-2 off.
TEST(CurveHeights, LieOnTheCurveBetweenItsPoints) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  for (const double force : {0.005, 0.02, 0.1}) {
    EXPECT_LT(largest_miss(structure, {Quantity::kForceAmplitude, force}, 0.7, 1.2), 1e-3);
    EXPECT_LT(largest_miss(structure, {Quantity::kForceAmplitude, force}, 1.2, 0.7), 1e-3);
  }
  EXPECT_LT(largest_miss(structure, {Quantity::kResponse, 0.5}, 0.7, 1.2), 1e-3);
}

/// A point of height h.
SteadyVibration at(double omega, double h) {
  SteadyVibration point;
  point.angular_frequency = omega;
  point.response = h;
  return point;
}

// A curve of straight pieces that goes to 3, back to 2 and on to 4: three heights between the
// folds, one outside; a point counts once.
TEST(CurveHeights, TellEachBranch) {
  ResponseCurve curve;
  for (const auto& [omega, h] : {std::pair{1.0, 1.0},
                                 {2.0, 1.5},
                                 {3.0, 2.0},
                                 {2.5, 2.5},
                                 {2.0, 3.0},
                                 {3.0, 3.5},
                                 {4.0, 4.0}}) {
    curve.points.push_back(at(omega, h));
  }
  const CurveHeights heights(curve, Quantity::kForceAmplitude);
  EXPECT_EQ(heights.at(1.5).size(), 1U);
  EXPECT_EQ(heights.at(3.5).size(), 1U);
  const std::vector<double> three = heights.at(2.5);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(three));
  EXPECT_NEAR(three[1], 2.5, 1e-12);  // a point
  for (const auto& [omega, h] : {std::pair{1.0, 1.0}, {4.0, 4.0}, {4.0 * (1.0 + 1e-12), 4.0}}) {
    ASSERT_EQ(heights.at(omega).size(), 1U) << omega;
    EXPECT_NEAR(heights.at(omega)[0], h, 1e-12);
  }
  EXPECT_TRUE(heights.at(0.9).empty());
  EXPECT_TRUE(heights.at(4.1).empty());
}

TEST(CurveHeights, OfACurveOfOnePoint) {
  ResponseCurve curve;
  EXPECT_TRUE(CurveHeights(curve, Quantity::kForceAmplitude).at(1.0).empty());
  curve.points.push_back(at(1.0, 2.0));
  EXPECT_EQ(CurveHeights(curve, Quantity::kForceAmplitude).at(1.0), std::vector<double>{2.0});
}

}  // namespace
}  // namespace microslip::curve_heights_test
