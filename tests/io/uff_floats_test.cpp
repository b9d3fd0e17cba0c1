// SPDX-License-Identifier: MIT
#include "microslip/io/uff_floats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/uff_support.hpp"

namespace microslip {
namespace {

using test::bytes_of_bits;

double decoded(UffFloat format, const std::string& bytes) {
  double value = 0.0;
  decode_uff_floats(format, bytes.data(), bytes.size(), {&value, 1});
  return value;
}

double ibm4(std::uint32_t bits) {
  const double value = decoded(UffFloat::kIbm4Big, bytes_of_bits(bits, false));
  EXPECT_EQ(decoded(UffFloat::kIbm4Little, bytes_of_bits(bits, true)), value);
  return value;
}

double ibm8(std::uint64_t bits) {
  const double value = decoded(UffFloat::kIbm8Big, bytes_of_bits(bits, false));
  EXPECT_EQ(decoded(UffFloat::kIbm8Little, bytes_of_bits(bits, true)), value);
  return value;
}

double vax(std::uint32_t bits) { return decoded(UffFloat::kVaxF, bytes_of_bits(bits, true)); }

// Patterns from the IBM System/370 Principles of Operation: base 16, excess 64.
TEST(UffFloats, Ibm) {
  EXPECT_EQ(ibm4(0x41100000), 1.0);
  EXPECT_EQ(ibm4(0xC276A000), -118.625);
  EXPECT_EQ(ibm4(0x40800000), 0.5);
  EXPECT_EQ(ibm4(0x00000000), 0.0);
  EXPECT_EQ(ibm4(0x00100000), std::ldexp(1.0, -260)) << "smallest normal, 16^-65";
  EXPECT_EQ(ibm4(0x7FFFFFFF), std::ldexp(16777215.0, 252 - 24)) << "largest";
  EXPECT_EQ(ibm8(0x4110000000000000), 1.0);
  EXPECT_EQ(ibm8(0xC276A00000000000), -118.625);
  EXPECT_EQ(ibm8(0x4019999999999999), std::ldexp(double{0x19999999999999}, -56));
}

// Words as on a VAX, the values those of the VAX Architecture Reference Manual's F_floating.
TEST(UffFloats, VaxF) {
  EXPECT_EQ(vax(0x00004080), 1.0);
  EXPECT_EQ(vax(0x0000C080), -1.0);
  EXPECT_EQ(vax(0x00004160), 3.5);
  EXPECT_EQ(vax(0x0000C160), -3.5);
  EXPECT_EQ(vax(0x0FD04149), static_cast<double>(3.14159F));
  EXPECT_EQ(vax(0x00000000), 0.0);
  EXPECT_EQ(vax(0x00000080), std::ldexp(1.0, -128)) << "smallest";
  EXPECT_EQ(vax(0xFFFF7FFF), std::ldexp(16777215.0, 127 - 24)) << "largest";
  EXPECT_TRUE(std::isnan(vax(0x00008000))) << "reserved operand";
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
  EXPECT_EQ(uff_float(1, 1, 4), UffFloat::kVaxF);
  EXPECT_EQ(uff_float(1, 1, 8), std::nullopt) << "D or G";
  EXPECT_EQ(uff_float(2, 1, 4), std::nullopt);
  EXPECT_EQ(uff_float(0, 2, 8), std::nullopt);
  EXPECT_EQ(uff_float(1, 4, 8), std::nullopt);
  EXPECT_EQ(uff_float(2, 3, 8), UffFloat::kIbm8Big);
}

}  // namespace
}  // namespace microslip
