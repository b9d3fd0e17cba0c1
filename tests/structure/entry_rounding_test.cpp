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
  // A uniform mesh has few different entries.
  EXPECT_EQ(entry_rounding(of_values({1968750.0, 3281250.0, 6562500.0, 98437.5, 131250.0})), 0.0);
}

}  // namespace
}  // namespace microslip::entry_rounding_test
