// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/closest_name.hpp"

#include <gtest/gtest.h>

#include <string>

namespace microslip::closest_name_test {
namespace {

TEST(ClosestName, FindsSlipsOfThePen) {
  EXPECT_EQ(closest_name("lenght_m", {"width_m", "length_m"}), "length_m") << "swapped";
  EXPECT_EQ(closest_name("Length_m", {"width_m", "length_m"}), "length_m") << "replaced";
  EXPECT_EQ(closest_name("lengt_m", {"width_m", "length_m"}), "length_m") << "left out";
  EXPECT_EQ(closest_name("length_mm", {"width_m", "length_m"}), "length_m") << "another unit";
}

TEST(ClosestName, CompletesAForgottenUnit) {
  EXPECT_EQ(closest_name("stiffness", {"joint", "stiffness_N_per_m"}), "stiffness_N_per_m");
  EXPECT_EQ(closest_name("stiff", {"stiffness_N_per_m"}), "") << "not at the end of a word";
}

TEST(ClosestName, TakesTheNearestOfSeveral) {
  EXPECT_EQ(closest_name("mode", {"node", "modes", "model"}), "node") << "the first of equals";
  EXPECT_EQ(closest_name("modess", {"node", "modes", "model"}), "modes");
}

TEST(ClosestName, IsEmptyWhereNothingIsNear) {
  EXPECT_EQ(closest_name("colour", {"length_m", "width_m"}), "");
  EXPECT_EQ(closest_name("ab", {"cd", "xb"}), "") << "more than a third differs";
  EXPECT_EQ(closest_name("", {"a"}), "");
  EXPECT_EQ(closest_name("a", {}), "");
  EXPECT_EQ(closest_name(std::string(10'000'000, 'x'), {"length_m"}), "");
}

}  // namespace
}  // namespace microslip::closest_name_test
