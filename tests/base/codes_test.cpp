// SPDX-License-Identifier: MIT
#include "microslip/base/codes.hpp"

#include <gtest/gtest.h>

namespace microslip::codes_test {
namespace {

TEST(Codes, AreThereOnce) {
  std::string codes;
  add_code(codes, "clipped");
  add_code(codes, "beats");
  add_code(codes, "clipped");
  EXPECT_EQ(codes, "clipped beats");
  add_code(codes, "clip");
  EXPECT_EQ(codes, "clipped beats clip") << "the beginning of a code is another one";
  add_code(codes, "");
  EXPECT_EQ(codes, "clipped beats clip");
}

TEST(Codes, OfWarningsKeepTheirOrder) {
  EXPECT_EQ(joined_codes({{"b", "x"}, {"a", "y"}, {"b", "z"}}), "b a");
  EXPECT_EQ(joined_codes({}), "");
}

}  // namespace
}  // namespace microslip::codes_test
