// SPDX-License-Identifier: MIT
#include "microslip/signal/recording/resampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "support/messages.hpp"

namespace microslip::resampling_test {
namespace {

constexpr double kStep = 1e-3;

/// Times that jitter by a share of the step, and a signal at them.
Recording jittering(std::size_t count, double share, const std::function<double(double)>& signal) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-share, share);
  Recording recording;
  recording.source = "r";
  Channel channel{
      .name = "a", .dimension = kAcceleration, .values = {}, .imaginary = {}, .attributes = {}};
  for (std::size_t i = 0; i < count; ++i) {
    const bool end = i == 0 || i + 1 == count;
    const double time = kStep * (static_cast<double>(i) + (end ? 0.0 : off(random)));
    recording.axis.values.push_back(time);
    channel.values.push_back(signal(time));
  }
  recording.channels.push_back(channel);
  return recording;
}

double largest_error(const Recording& even, const std::function<double(double)>& signal) {
  double largest = 0.0;
  for (std::size_t i = 0; i < even.size(); ++i) {
    const double value = even.channels.front().values[i];
    largest = std::max(largest, std::abs(value - signal(even.axis.at(i))));
  }
  return largest;
}

// A polynomial of degree five is its own interpolation; what is left is rounding, of values up to 1
// by weights up to some ten at the ends.
TEST(Resampling, IsExactForPolynomialsOfDegreeFive) {
  const auto signal = [](double t) {
    const double x = t / 0.05 - 1.0;
    return ((((x - 0.5) * x + 0.3) * x - 0.7) * x + 0.2) * x - 0.1;
  };
  const Recording even = resampled(jittering(101, 0.3, signal), 1.7e3);
  EXPECT_TRUE(even.axis.even());
  EXPECT_EQ(even.size(), 171U);
  EXPECT_EQ(even.axis.start, 0.0);
  EXPECT_DOUBLE_EQ(even.sampling_rate(), 1.7e3);
  EXPECT_LT(largest_error(even, signal), 1e-13);
}

// By the remainder of the polynomial, which for times that jitter by 10 % is larger than the bound
// for even ones by less than 2, and at the ends by less than 40.
TEST(Resampling, KeepsASineOfTwelvePointsAPeriod) {
  const auto signal = [](double t) {
    return std::sin(2.0 * std::numbers::pi * t / (12.0 * kStep));
  };
  const Recording even = resampled(jittering(600, 0.1, signal), 1e3);
  EXPECT_EQ(even.size(), 600U);
  EXPECT_LT(largest_error(even, signal), 40.0 * 1e-4);
  double inside = 0.0;
  for (std::size_t i = 6; i + 6 < even.size(); ++i) {
    const double value = even.channels.front().values[i];
    inside = std::max(inside, std::abs(value - signal(even.axis.at(i))));
  }
  EXPECT_LT(inside, 2e-4);
}

TEST(Resampling, LeavesEvenTimesOfTheSameRate) {
  Recording recording = jittering(50, 0.0, [](double t) { return std::cos(900.0 * t); });
  recording.axis = {.dimension = kTime, .start = 2.0, .step = kStep, .values = {}};
  const Recording again = resampled(recording, 1.0 / kStep);
  ASSERT_EQ(again.size(), recording.size());
  EXPECT_EQ(again.axis.start, 2.0);
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_NEAR(again.channels[0].values[i], recording.channels[0].values[i], 1e-12);
  }
}

TEST(ResamplingFault, GapsLowRatesAndOtherAxes) {
  const auto line = [](double t) { return t; };
  const auto refused = [](const Recording& recording, double rate) {
    return test::message_or("nothing", [&] { return resampled(recording, rate); });
  };
  Recording gap = jittering(100, 0.0, line);
  for (std::size_t i = 60; i < 100; ++i) gap.axis.values[i] += 0.01;
  EXPECT_NE(refused(gap, 1e3).find("r: time is without a sample from 0.059 to 0.07 s"),
            std::string::npos)
      << refused(gap, 1e3);
  EXPECT_NE(refused(jittering(100, 0.1, line), 500.0).find("a filter against aliasing"),
            std::string::npos);
  EXPECT_NE(refused(jittering(100, 0.1, line), 2e5).find("up to 100 times"), std::string::npos);
  Recording frequency = jittering(100, 0.1, line);
  frequency.axis.dimension = kFrequency;
  EXPECT_NE(refused(frequency, 1e3).find("not over time"), std::string::npos);
  Recording complex = jittering(100, 0.1, line);
  complex.channels[0].imaginary = complex.channels[0].values;
  EXPECT_NE(refused(complex, 1e3).find("channel 'a' is complex"), std::string::npos);
}

TEST(ResamplingFault, SaysHowUnevenTimesAre) {
  Recording recording = jittering(101, 0.0, [](double) { return 0.0; });
  recording.axis.values[50] += 2e-4;
  EXPECT_STREQ(
      uneven_times(recording).what(),
      "r: time is uneven: intervals of 0.0008 to 0.0012 s; must be evenly spaced. Resample "
      "it first: `microslip convert IN OUT --resample 1000Hz`.");
}

}  // namespace
}  // namespace microslip::resampling_test
