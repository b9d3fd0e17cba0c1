// SPDX-License-Identifier: MIT
#include "microslip/structure/entry_rounding.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace microslip::entry_rounding_test {
namespace {

SymmetricEntries of_values(std::vector<double> values) {
  return {.size = values.size(), .row = {}, .column = {}, .value = std::move(values)};
}

/// Values without a pattern, over six orders of magnitude, of either sign and with zeros.
std::vector<double> values() {
  std::vector<double> all;
  for (int i = 1; i <= 200; ++i) {
    all.push_back(std::sin(i) * std::pow(10.0, i % 7));
    all.push_back(0.0);
  }
  return all;
}

// 5·10⁻ᵈ is half a unit of the last of d digits of 1.000…, the largest share.
TEST(EntryRounding, IsThatOfTheDigits) {
  EXPECT_EQ(entry_rounding(of_values(values())), 0.0);
  for (const int digits : {6, 10, 14, 15}) {
    std::vector<double> rounded = values();
    for (double& value : rounded) value = std::stod(fmt::format("{:.{}e}", value, digits - 1));
    const double expected = 5.0 * std::pow(10.0, -digits);
    EXPECT_NEAR(entry_rounding(of_values(rounded)), expected, 1e-9 * expected) << digits;
  }
}

TEST(EntryRounding, IsThatOfSinglePrecision) {
  std::vector<double> single = values();
  for (double& value : single) value = static_cast<float>(value);
  EXPECT_EQ(entry_rounding(of_values(single)), 0x1p-24);
}

// Written in full: numbers of springs and masses, a stiff spring beside soft ones, one value alone.
TEST(EntryRounding, IsNoneOfExactNumbers) {
  EXPECT_EQ(entry_rounding(of_values({3e6, -1e6, 1e6, 2.5e5, 7000.0})), 0.0);
  EXPECT_EQ(entry_rounding(of_values({1000000001.0, -1e9, 1e9, 1.0, 2.0})), 0.0);
  EXPECT_EQ(entry_rounding(of_values({123456.7, 123456.7})), 0.0);
  EXPECT_EQ(entry_rounding(of_values({})), 0.0);
  // Of different lengths, and all of five digits.
  std::vector<double> whole;
  std::vector<double> short_ones;
  for (int i = 1; i <= 200; ++i) {
    whole.push_back(7.0 * i * i * i);
    short_ones.push_back(10000.0 + 37.0 * i);
  }
  EXPECT_EQ(entry_rounding(of_values(whole)), 0.0);
  EXPECT_EQ(entry_rounding(of_values(short_ones)), 0.0);
  // A uniform mesh has few different entries.
  EXPECT_EQ(entry_rounding(of_values({1968750.0, 3281250.0, 6562500.0, 98437.5, 131250.0})), 0.0);
}

// The entries of a uniform bar of eight digits, and some that are exact.
TEST(EntryRounding, OfAFewEntriesIsPossible) {
  const SymmetricEntries bar = of_values(
      {-1516750100.0, -227512510000.0, 13482223.0, 26964446.0, 455025030000.0, 6741111.5});
  EXPECT_EQ(entry_rounding(bar), 0.0);
  EXPECT_NEAR(possible_entry_rounding(bar), 5e-8, 1e-16);
  EXPECT_EQ(possible_entry_rounding(of_values({0.1F, 0.7F})), 0x1p-24);
  EXPECT_EQ(possible_entry_rounding(of_values({3e6, -1e6, 1e6, 2.5e5, 7000.0})), 0.0);
  EXPECT_EQ(possible_entry_rounding(of_values({1968750.0, 3281250.0, 6562500.0, 131250.0})), 0.0);
  EXPECT_EQ(possible_entry_rounding(of_values({0.1, 0.2, 1.0 / 3.0})), 0.0);
  EXPECT_EQ(possible_entry_rounding(of_values({})), 0.0);
}

}  // namespace
}  // namespace microslip::entry_rounding_test
