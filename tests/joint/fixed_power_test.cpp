// SPDX-License-Identifier: MIT
#include "microslip/joint/fixed_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace microslip::fixed_power_test {
namespace {

// By long double, which knows the power to a thousandth of the bound.
void expect_accurate(const FixedPower& power, double s, double exponent) {
  ASSERT_TRUE(power.covers(s)) << s;
  const long double exact = std::pow(static_cast<long double>(s), exponent);
  EXPECT_LT(std::abs(static_cast<double>(power(s) / exact - 1.0L)), 5e-16)
      << s << " to the " << exponent;
}

TEST(FixedPower, IsWithinAFewRoundings) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const double exponent : {1e-3, 0.1, 0.5, 1.0, 1.7, 2.0, 3.3, 5.0, 8.0}) {
    for (const double most : {1e-9, 0.7, 1.0, 64.0, 12345.6}) {
      const FixedPower power(exponent, most);
      for (int i = 0; i < 2000; ++i) {
        expect_accurate(power, most * std::exp2(-60.0 * uniform(random)), exponent);
      }
    }
  }
}

// Where one entry of the tables follows another: powers of two and 64ths of the octave, from both
// sides, and the ends of the range.
TEST(FixedPower, IsAsAccurateAtTheEdgesOfItsTables) {
  const double exponent = 0.6;
  const FixedPower power(exponent, 300.0);
  for (int octave = -40; octave <= 7; ++octave) {
    for (int i = 0; i < 64; ++i) {
      const double edge = std::ldexp(1.0 + i / 64.0, octave);
      expect_accurate(power, edge, exponent);
      expect_accurate(power, std::nextafter(edge, 0.0), exponent);
    }
  }
  expect_accurate(power, 300.0, exponent);
  EXPECT_FALSE(power.covers(std::nextafter(300.0, HUGE_VAL)));
}

TEST(FixedPower, CoversNothingElse) {
  const FixedPower power(1.5, 2.0);
  for (const double s : {0.0, -1.0, 2.1, 1e-300, HUGE_VAL, std::nan("")}) {
    EXPECT_FALSE(power.covers(s)) << s;
  }
  // No table: exponents that the series does not reach, powers that are no normal numbers.
  for (const double exponent : {0.0, -0.5, 8.1, std::nan("")}) {
    EXPECT_FALSE(FixedPower(exponent, 1.0).covers(0.5)) << exponent;
  }
  for (const double most : {0.0, HUGE_VAL, 1e-40, 1e200}) {
    EXPECT_FALSE(FixedPower(8.0, most).covers(0.5 * most)) << most;
  }
}

}  // namespace
}  // namespace microslip::fixed_power_test
