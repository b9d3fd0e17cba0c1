// SPDX-License-Identifier: MIT
#include "microslip/calibrate/step_share.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip::step_share_test {
namespace {

/// The distance of x ← x + s(μx − x) from its fixed point 0 after some passes, from 1.
double distance_after(int passes, double eigenvalue, StepShare share) {
  double x = 1.0;
  for (int i = 0; i < passes; ++i) {
    const double step = share.share() * (eigenvalue * x - x);
    x += step;
    share.take(std::abs(step));
  }
  return std::abs(x);
}

// With half of a step the eigenvalue −3 cycles for ever, and −7 grows; shares below a half and a
// quarter are contractions.
TEST(StepShare, EndsCycles) {
  EXPECT_LT(distance_after(30, -3.0, StepShare(0.5)), 1e-5);
  EXPECT_LT(distance_after(60, -7.0, StepShare(0.5)), 1e-5);
}

// Where steps already lead there, none is shortened.
TEST(StepShare, LeavesAContractionAlone) {
  StepShare share(0.5);
  for (int i = 0; i < 20; ++i) share.take(std::pow(0.5, i));
  EXPECT_DOUBLE_EQ(share.share(), 0.5);
  EXPECT_DOUBLE_EQ(share.of_whole_step(1e-5), 2e-5);
}

// A change that rounding keeps up is no reason for ever shorter steps.
TEST(StepShare, EndsAtASixteenth) {
  StepShare share(0.5);
  for (int i = 0; i < 100; ++i) share.take(1e-6 * (1.0 + (i % 2)));
  EXPECT_DOUBLE_EQ(share.share(), 1.0 / 16.0);
}

}  // namespace
}  // namespace microslip::step_share_test
