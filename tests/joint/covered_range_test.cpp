// SPDX-License-Identifier: MIT
#include "microslip/joint/covered_range.hpp"

#include <gtest/gtest.h>

#include "support/densities.hpp"

namespace microslip::covered_range_test {
namespace {

// k = 1.7e5 N/m: 100 µm are 17 N.
TEST(CoveredRange, EndsTwoPercentAboveTheHighestLevel) {
  const Joint joint = testing::reference_joint();
  const double amplitude = 17.0 / joint.stiffness();
  EXPECT_FALSE(beyond_identification(joint, amplitude, 17.0));
  EXPECT_FALSE(beyond_identification(joint, 1.019 * amplitude, 17.0));
  const auto warning = beyond_identification(joint, 1.5 * amplitude, 17.0);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->code, "beyond_identification");
  EXPECT_NE(warning->text.find("150 µm, 1.5 times the 100 µm"), std::string::npos) << warning->text;
}

TEST(CoveredRange, HasNoEndWhereNothingIsToldOfLevels) {
  EXPECT_FALSE(beyond_identification(testing::reference_joint(), 1.0, {}));
}

}  // namespace
}  // namespace microslip::covered_range_test
