// SPDX-License-Identifier: MIT

// The axis of points that a file gives one by one, whatever the file: HDF5, MAT and TDMS store the
// same numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip::points_axis_test {
namespace {

struct Read {
  Axis axis;
  std::vector<Warning> warnings;
};

Read read(std::vector<double> points, const std::string& unit,
          std::optional<double> stated_step = {}) {
  Read read;
  read.axis =
      axis_of_points({std::move(points), unit, kTime, "a"}, stated_step, read.warnings).axis;
  return read;
}

template <class Point>
std::vector<double> points(std::size_t count, const Point& point) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(point(static_cast<double>(i)));
  return all;
}

// Each of these is a number of single precision as well, of which 1 Hz or 1007 Hz explains the
// rounding: whole numbers have none.
TEST(PointsAxis, WholeNumbersThatAreEvenAreExact) {
  EXPECT_EQ(read({0, 999999550, 1999999100}, "ns").axis.step, 0.99999955);
  EXPECT_EQ(read({0, 999999488, 1999998976}, "ns").axis.step, 0.999999488);
  EXPECT_EQ(read({0, 1048576, 2097152}, "us").axis.step, 1.048576);
  const Axis many = read(points(135, [](double i) { return 993048 * i; }), "ns").axis;
  EXPECT_EQ(many.step, 993048e-9);
  EXPECT_EQ(read({0, 999999488, 1999998976}, "ns", 1.0).axis.step, 1.0) << "as stated";
}

// 48 kHz in whole microseconds, as in a table of text: 0, 21, 42, 63, 83, ...
TEST(PointsAxis, WholeNumbersAreRoundedToTheirUnit) {
  const auto rounded = [](double offset) {
    return points(4800, [&](double i) { return offset + std::round(i * 1e6 / 48000); });
  };
  EXPECT_EQ(read(rounded(0), "us").axis.step, 1.0 / 48000);
  EXPECT_EQ(read(rounded(1e9), "us").axis.step, 1.0 / 48000) << "exact in double precision alone";
  std::vector<double> uneven = rounded(0);
  uneven[100] += 6;  // more than 0.24 of a step
  EXPECT_FALSE(read(uneven, "us").axis.even());
}

// Whole numbers above 2²⁴ that are multiples of 64 may be nanoseconds in single precision.
TEST(PointsAxis, LargeSinglesKeepTheirPrecision) {
  const auto single = [](double i) {
    return static_cast<double>(static_cast<float>(1e9 + 1e6 * i / 1.024));
  };
  EXPECT_EQ(read(points(500, single), "ns").axis.step, 1.0 / 1024);
}

// numpy.datetime64 and posixtime() in milliseconds, microseconds and nanoseconds as doubles: those
// are 2.4e-4 ms, 0.25 µs and 256 ns apart there, by which steps are off at most.
TEST(PointsAxis, DoublesMayCountFrom1970) {
  constexpr double kBegin = 1704067200123;  // ms
  const auto expect = [](const Read& read, double step, double off) {
    EXPECT_TRUE(read.axis.even());
    EXPECT_EQ(read.axis.start, 0.0);
    EXPECT_NEAR(read.axis.step, step, off);
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_EQ(read.warnings[0].code, "times_since_1970");
  };
  const auto times = [&](double begin, double step) {
    return points(1000, [&](double i) { return begin + step * i; });
  };
  expect(read(times(kBegin, 1), ""), 1e-3, 0.0);
  expect(read(times(kBegin, 0.1), ""), 1e-4, 2.4e-7 / 999);
  expect(read(times(kBegin * 1e3, 20), ""), 20e-6, 1e-19);  // one rounding to SI
  expect(read(times(kBegin * 1e6, 1e6), ""), 1e-3, 256e-9 / 999);
  const Read uneven = read({kBegin, kBegin + 1, kBegin + 4}, "");
  EXPECT_EQ(uneven.axis.values, (std::vector{0.0, 1e-3, 4e-3}));
  EXPECT_EQ(read(times(kBegin, 1), "ms").warnings.size(), 0U);
  EXPECT_EQ(read(times(1704067200, 1), "").warnings.size(), 0U) << "seconds";
}

// Whole milliseconds at 1.6 kHz, of which some are equal.
TEST(PointsAxis, ARateThatIsStatedIsThatOfAClockThatRounds) {
  const std::vector<double> times = points(4000, [](double i) { return std::round(i / 1.6); });
  const Read stated = read(times, "ms", 1.0 / 1600.0);
  EXPECT_EQ(stated.axis.step, 1.0 / 1600.0);
  EXPECT_TRUE(stated.warnings.empty());
  const Read other = read(times, "ms", 1.0 / 1700.0);
  EXPECT_NEAR(other.axis.step, 1.0 / 1600.0, 1e-3 / 4000.0) << "a last digit of the span";
  EXPECT_EQ(other.warnings.at(0).code, "times_rounded");
  const auto asked = [&](double rate) {
    std::vector<Warning> warnings;
    const PointsInFile file{
        .points = times, .unit = "ms", .usual = kTime, .place = "a", .rate = rate};
    return axis_of_points(file, {}, warnings);
  };
  EXPECT_EQ(asked(1600.0).axis.step, 1.0 / 1600.0);
  EXPECT_TRUE(asked(1600.0).rate_used);
  EXPECT_THROW((void)asked(1700.0), InputError);
}

TEST(PointsAxis, WholeNumbersInLongStepsAreDoubted) {
  EXPECT_EQ(read({0, 1000, 2000}, "").warnings.at(0).code, "times_in_seconds");
  EXPECT_EQ(read({0, 1000, 2000}, "ms").warnings.size(), 0U);
  EXPECT_EQ(read({0, 2, 4}, "").warnings.size(), 0U);
}

}  // namespace
}  // namespace microslip::points_axis_test
