// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/density_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/base/error.hpp"

namespace microslip::density_comparison_test {
namespace {

/// A uniform density on 0 … 10 N that the levels reach as far as.
Identification uniform(double weight) {
  Identification found(IdentificationMethod::kInversion,
                       Joint(1e3, SlipDensity({UniformPart{0.0, 10.0, weight}})));
  found.covered_to = 10.0;
  return found;
}

const SlipDensity kTruth({UniformPart{0.0, 10.0, 1.0}});

// Of constants the norm drops out. Rounding only.
TEST(DensityComparison, ErrorOfAConstantIsItsOwn) {
  EXPECT_NEAR(density_error(uniform(0.9), kTruth), 0.1, 1e-14);
  EXPECT_NEAR(density_error(uniform(1.0), kTruth), 0.0, 1e-14);
  EXPECT_NEAR(density_error(uniform(0.9).joint.density(), 10.0, kTruth), 0.1, 1e-14);
}

// The truth is 0 beyond half of the range: ‖φ − φ_true‖² = ½ 0.1², ‖φ_true‖² = ½ 0.2² over 0 … 1.
// One point in 2001 lies on the jump.
TEST(DensityComparison, TakesTheRangeAsAShareOfWhatTheLevelsReach) {
  const SlipDensity half({UniformPart{0.0, 5.0, 1.0}});
  EXPECT_NEAR(density_error(uniform(1.0), half, {0.0, 1.0}), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(density_error(uniform(1.0), half, {0.0, 0.4}), 0.5, 1e-14);
}

// A line from 0 at 0 N to the truth at 5 N: the relative error 1 − s, s = 0 … 1, has the mean
// square 1/3; the mean over 2001 points is good to 1e-4.
TEST(DensityComparison, TakesADensityAtPoints) {
  EXPECT_NEAR(density_error({0.0, 5.0}, {0.0, 0.1}, 10.0, kTruth, {0.0, 0.5}), std::sqrt(1.0 / 3.0),
              1e-4);
  EXPECT_NEAR(density_error({1.0, 2.0}, {-0.1, -0.1}, 10.0, kTruth), 2.0, 1e-14);
  EXPECT_THROW((void)density_error({1.0, 2.0}, {0.1}, 10.0, kTruth), InputError);
  EXPECT_THROW((void)density_error({}, {}, 10.0, kTruth), InputError);
}

// A band that rises through the truth, 0.1, contains it where lower ≤ 0.1 ≤ upper: from 2.5 to
// 7.5 N of 0 … 10 N.
TEST(DensityComparison, CoverageIsTheShareInsideTheBand) {
  Identification found = uniform(1.0);
  found.slip_force = {0.0, 10.0};
  found.lower = {0.025, 0.125};
  found.upper = {0.075, 0.175};
  EXPECT_NEAR(band_coverage(found, kTruth, {0.0, 1.0}), 0.5, 1e-3);
  found.lower = {0.0, 0.0};
  found.upper = {0.2, 0.2};
  EXPECT_EQ(band_coverage(found, kTruth), 1.0);
}

TEST(DensityComparison, RefusesWhatCannotBeCompared) {
  EXPECT_THROW((void)density_error(uniform(1.0), kTruth, {0.5, 0.5}), InputError);
  EXPECT_THROW((void)density_error(uniform(1.0), kTruth, {0.0, 1.1}), InputError);
  EXPECT_THROW((void)density_error(uniform(1.0), SlipDensity({UniformPart{20.0, 30.0, 1.0}})),
               InputError);
  EXPECT_THROW((void)band_coverage(uniform(1.0), kTruth), InputError);
}

}  // namespace
}  // namespace microslip::density_comparison_test
