// SPDX-License-Identifier: MIT
#include "microslip/base/interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::interpolation_test {
namespace {

TEST(Interpolation, IsLinearBetweenKnotsAndConstantBeyond) {
  const std::vector<double> knots{1.0, 2.0, 4.0};
  const std::vector<double> values{10.0, 20.0, -20.0};
  EXPECT_EQ(interpolate(knots, values, 0.0), 10.0);
  EXPECT_EQ(interpolate(knots, values, 1.0), 10.0);
  EXPECT_EQ(interpolate(knots, values, 1.5), 15.0);
  EXPECT_EQ(interpolate(knots, values, 2.0), 20.0);
  EXPECT_EQ(interpolate(knots, values, 3.0), 0.0);
  EXPECT_EQ(interpolate(knots, values, 5.0), -20.0);
  EXPECT_TRUE(std::isnan(interpolate(knots, values, std::nan(""))));
}

TEST(Interpolation, IntegralIsThatOfTrapezoids) {
  EXPECT_EQ(integral({1.0, 2.0, 4.0}, {10.0, 20.0, -20.0}), 15.0);
  EXPECT_EQ(integral({1.0}, {10.0}), 0.0);
}

TEST(Interpolation, RefusesWhatIsNoFunction) {
  EXPECT_THROW((void)integral({}, {}), InputError);
  EXPECT_THROW((void)interpolate({}, {}, 1.0), InputError);
  EXPECT_THROW((void)interpolate({1.0, 2.0}, {1.0}, 1.0), InputError);
}

}  // namespace
}  // namespace microslip::interpolation_test
