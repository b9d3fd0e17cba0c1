// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_floats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/uff_support.hpp"

namespace microslip::uff_floats_test {
namespace {

using test::bytes_of_bits;

double decoded(UffFloat format, const std::string& bytes) {
  double value = 0.0;
  decode_uff_floats(format, bytes.data(), bytes.size(), {&value, 1});
  return value;
}

TEST(UffFloats, IeeeInBothOrders) {
  for (const double value : {1.0, -0.1, 5e-324, 1.7976931348623157e308, 1e30}) {
    EXPECT_EQ(decoded(UffFloat::kIeee8Little, test::ieee8(value, true)), value);
    EXPECT_EQ(decoded(UffFloat::kIeee8Big, test::ieee8(value, false)), value);
  }
  EXPECT_EQ(decoded(UffFloat::kIeee4Little, test::ieee4(-0.1, true)), double{-0.1F});
  EXPECT_EQ(decoded(UffFloat::kIeee4Big, test::ieee4(-0.1, false)), double{-0.1F});
}

TEST(UffFloats, KnowsWhatItDoesNotKnow) {
  EXPECT_EQ(uff_float(1, 1, 4), std::nullopt) << "DEC";
  EXPECT_EQ(uff_float(2, 1, 4), std::nullopt);
  EXPECT_EQ(uff_float(0, 2, 8), std::nullopt);
  EXPECT_EQ(uff_float(1, 4, 8), std::nullopt);
  EXPECT_EQ(uff_float(2, 3, 8), std::nullopt) << "IBM";
  EXPECT_EQ(uff_float(2, 2, 8), UffFloat::kIeee8Big);
}

}  // namespace
}  // namespace microslip::uff_floats_test
