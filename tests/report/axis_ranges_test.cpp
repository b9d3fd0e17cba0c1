// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/axis_ranges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "report/support.hpp"

namespace microslip::axis_ranges_test {
namespace {

Figure line(std::vector<double> x, std::vector<double> y) {
  return {.layers = {LineLayer{.x = std::move(x), .y = std::move(y)}}};
}

TEST(AxisRanges, CoverTheDataAndALittleMore) {
  const AxisRanges ranges = axis_ranges(line({55.0, 56.0}, {-1.0, 1.0}));
  // 4 % of the length on each side; rounding only.
  EXPECT_NEAR(ranges.x.from, 54.96, 1e-12);
  EXPECT_NEAR(ranges.x.to, 56.04, 1e-12);
  EXPECT_NEAR(ranges.y.from, -1.08, 1e-12);
  EXPECT_NEAR(ranges.y.to, 1.08, 1e-12);
}

TEST(AxisRanges, StartAtZeroWhereThatIsNear) {
  const AxisRanges ranges = axis_ranges(line({0.1, 10.0}, {-10.0, 0.0}));
  EXPECT_EQ(ranges.x.from, 0.0);
  EXPECT_EQ(ranges.y.to, 0.0);
  EXPECT_LT(ranges.y.from, -10.0);
}

TEST(AxisRanges, IncludeBarsBandsAndMarkers) {
  const AxisRanges ranges = axis_ranges(
      {.layers = {PointLayer{.x = {5.0}, .y = {5.0}, .x_error = {4.0}, .y_error = {4.5}},
                  BandLayer{.x = {5.0}, .lower = {-3.0}, .upper = {6.0}}, MarkerLayer{.x = 20.0}}});
  EXPECT_EQ(ranges.x.from, 0.0);
  EXPECT_GT(ranges.x.to, 20.0);
  EXPECT_LT(ranges.y.from, -3.0);
  EXPECT_GT(ranges.y.to, 9.5);
}

TEST(AxisRanges, ALogarithmicAxisTakesPositiveValuesOnly) {
  Figure figure = line({1.0, 2.0, 3.0}, {0.0, 1e-3, 1e2});
  figure.y.log = true;
  figure.layers.emplace_back(PointLayer{.x = {2.0}, .y = {1.0}, .y_error = {5.0}});
  const AxisRanges ranges = axis_ranges(figure);
  // 4 % of the five decades.
  EXPECT_NEAR(std::log10(ranges.y.from), -3.2, 1e-12);
  EXPECT_NEAR(std::log10(ranges.y.to), 2.2, 1e-12);
}

TEST(AxisRanges, TakeWhatIsAskedForAndFitTheOtherAxisToIt) {
  Figure figure = line({0.0, 1.0, 100.0}, {2.0, 3.0, 1000.0});
  figure.x.range = AxisRange{.from = 0.0, .to = 2.0};
  const AxisRanges ranges = axis_ranges(figure);
  EXPECT_EQ(ranges.x.to, 2.0);
  EXPECT_LT(ranges.y.to, 4.0);
  figure.x.range = AxisRange{.from = 200.0, .to = 300.0};
  EXPECT_GT(axis_ranges(figure).y.to, 1000.0);
}

TEST(AxisRanges, AreNeverEmpty) {
  for (const double value : {0.0, 1e-120, 5e-5, -3.0, 1e100}) {
    const AxisRanges ranges = axis_ranges(line({value}, {value}));
    EXPECT_LT(ranges.x.from, ranges.x.to) << value;
    EXPECT_LE(ranges.x.from, value);
    EXPECT_GE(ranges.x.to, value);
  }
  Figure figure = line({5e-5}, {5e-5});
  figure.x.log = true;
  const AxisRanges ranges = axis_ranges(figure);
  // Half a decade, on which there is a tick or two.
  EXPECT_NEAR(std::log10(ranges.x.to / ranges.x.from), 0.5, 1e-12);
  EXPECT_NEAR(ranges.x.from * ranges.x.to, 25e-10, 1e-20);
}

TEST(AxisFraction, IsZeroAtTheStartAndOneAtTheEnd) {
  EXPECT_EQ(axis_fraction({.from = 2.0, .to = 4.0}, false, 3.0), 0.5);
  EXPECT_NEAR(axis_fraction({.from = 1.0, .to = 100.0}, true, 10.0), 0.5, 1e-15);
  EXPECT_EQ(axis_fraction({.from = 1.0, .to = 100.0}, true, 0.0),
            -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace microslip::axis_ranges_test
