// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/axis_ticks.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "microslip/report/drawing/axis_ranges.hpp"

namespace microslip::axis_ticks_test {
namespace {

constexpr Font kFont{.size = 13.0};
using Strings = std::vector<std::string>;

Strings texts(const Ticks& ticks) {
  Strings result;
  for (const TickLabel& label : ticks.labelled) {
    result.push_back(label.text + (label.exponent.empty() ? "" : "^" + label.exponent));
  }
  return result;
}

Strings across(double from, double to, bool log, double length = 700.0) {
  return texts(axis_ticks({.from = from, .to = to}, log, length, false, kFont));
}

TEST(AxisTicks, LinearOnesAreRoundNumbers) {
  EXPECT_EQ(across(0.0, 26.0, false, 400.0), (Strings{"0", "5", "10", "15", "20", "25"}));
  EXPECT_EQ(across(-0.35, 0.3, false, 300.0), (Strings{"−0.2", "0", "0.2"}));
}

TEST(AxisTicks, ValuesAreTheDecimalNumbersOfTheirLabels) {
  const Ticks ticks = axis_ticks({.from = 0.0, .to = 1.0}, false, 700.0, false, kFont);
  ASSERT_EQ(ticks.labelled.size(), 11U);
  EXPECT_EQ(ticks.labelled[3].value, 0.3);  // not 0.1 + 0.1 + 0.1
  EXPECT_EQ(ticks.labelled[7].value, 0.7);
}

TEST(AxisTicks, SmallAndLargeNumbersHaveAPowerOfTen) {
  EXPECT_EQ(across(0.0, 2.1e-6, false, 200.0), (Strings{"0", "1×10^−6", "2×10^−6"}));
  EXPECT_EQ(across(0.0, 2.1e7, false, 200.0), (Strings{"0", "1×10^7", "2×10^7"}));
}

TEST(AxisTicks, NeighboursAlwaysReadDifferently) {
  const Strings labels = across(1e6, 1e6 + 1.0, false);
  ASSERT_GE(labels.size(), 3U);
  for (std::size_t i = 1; i < labels.size(); ++i) EXPECT_NE(labels[i], labels[i - 1]);
}

TEST(AxisTicks, LogarithmicOnesArePowersOfTen) {
  EXPECT_EQ(across(2e-4, 30.0, true), (Strings{"10^−3", "10^−2", "10^−1", "10^0", "10^1"}));
  const Ticks ticks = axis_ticks({.from = 0.9, .to = 1100.0}, true, 700.0, false, kFont);
  EXPECT_EQ(ticks.minor.size(), 29U);  // 0.9, three times 1 to 9, 1000
}

TEST(AxisTicks, AShortLogarithmicAxisHasOthersToo) {
  EXPECT_EQ(across(0.4, 60.0, true), (Strings{"0.5", "1", "2", "5", "10", "20", "50"}));
  EXPECT_EQ(across(2.5, 7.5, true), (Strings{"3", "4", "5", "6", "7"}));
  EXPECT_EQ(across(55.0, 56.0, true, 300.0), (Strings{"55", "55.2", "55.4", "55.6", "55.8", "56"}));
}

TEST(AxisTicks, ALongLogarithmicAxisIsThinnedOut) {
  EXPECT_EQ(across(1e-20, 1e20, true, 300.0),
            (Strings{"10^−20", "10^−10", "10^0", "10^10", "10^20"}));
}

TEST(AxisTicks, LabelsNeverTouch) {
  const std::vector<AxisRange> ranges = {{0.0, 1.0},         {-3e-7, 4e-3},  {1e6, 1e6 + 1e-2},
                                         {1.23e-9, 1.24e-9}, {1e-9, 1e9},    {0.9, 1.1},
                                         {3.0, 400.0},       {1e-100, 1e100}};
  for (const AxisRange& range : ranges) {
    for (const double length : {40.0, 150.0, 700.0, 5000.0}) {
      for (const bool log : {false, true}) {
        if (log && range.from <= 0.0) continue;
        const auto labels = axis_ticks(range, log, length, false, kFont).labelled;
        // With two labels there is no choice left.
        for (std::size_t i = 1; labels.size() > 2 && i < labels.size(); ++i) {
          const double distance = length * (axis_fraction(range, log, labels[i].value) -
                                            axis_fraction(range, log, labels[i - 1].value));
          const double half_widths =
              0.5 * (label_width(labels[i], kFont) + label_width(labels[i - 1], kFont));
          EXPECT_GT(distance, half_widths) << range.from << " " << range.to << " " << length;
        }
      }
    }
  }
}

TEST(AxisTicks, OfDegreesArePartsOfARightAngle) {
  const auto degrees = [](double from, double to, double length) {
    std::vector<double> values;
    for (const TickLabel& label :
         axis_ticks({.from = from, .to = to}, false, length, true, kFont, true).labelled) {
      values.push_back(label.value);
    }
    return values;
  };
  EXPECT_EQ(degrees(-5.0, 185.0, 150.0), (std::vector{0.0, 45.0, 90.0, 135.0, 180.0}));
  EXPECT_EQ(degrees(-5.0, 185.0, 100.0), (std::vector{0.0, 90.0, 180.0}));
  EXPECT_EQ(degrees(0.0, 360.0, 60.0), (std::vector{0.0, 180.0, 360.0}));
  EXPECT_EQ(degrees(81.0, 83.0, 100.0).size(), 3U) << "no part of a right angle within";
}

}  // namespace
}  // namespace microslip::axis_ticks_test
