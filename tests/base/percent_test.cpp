// SPDX-License-Identifier: MIT
#include "microslip/base/percent.hpp"

#include <gtest/gtest.h>

namespace microslip::percent_test {
namespace {

TEST(PercentText, HasTwoDigitsAtLeastAndNoExponentAbove) {
  EXPECT_EQ(percent_text(1.4), "140.0 %");
  EXPECT_EQ(percent_text(0.1234), "12.3 %");
  EXPECT_EQ(percent_text(0.01), "1.0 %");
  EXPECT_EQ(percent_text(0.005), "0.50 %");
  EXPECT_EQ(percent_text(-0.00567), "-0.57 %");
  EXPECT_EQ(percent_text(7.12e-8), "7.1e-06 %");
}

}  // namespace
}  // namespace microslip::percent_test
