// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/even_axis.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace microslip::even_axis_test {
namespace {

constexpr Unit kSecond{.dimension = kTime};

/// The axis of times printed one way and read again.
template <class Time, class Print>
Axis printed(std::size_t n, const Time& time, const Print& print) {
  std::vector<double> values;
  PrintedDigits digits;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string text = print(time(static_cast<double>(i)));
    digits.add(text);
    values.push_back(std::strtod(text.c_str(), nullptr));
  }
  return axis_from_printed(values, kSecond, digits);
}

const auto fixed = [](int decimals) {
  return [decimals](double t) { return fmt::format("{:.{}f}", t, decimals); };
};
const auto significant = [](int digits) {
  return [digits](double t) { return fmt::format("{:.{}g}", t, digits); };
};
const auto scientific = [](int decimals) {
  return [decimals](double t) { return fmt::format("{:.{}e}", t, decimals); };
};

TEST(PrintedDigits, CountsDecimalsAndSignificantDigits) {
  const auto digits = [](const char* text) {
    PrintedDigits d;
    d.add(text);
    return std::pair{d.decimals, d.significant};
  };
  EXPECT_EQ(digits("0.00025"), (std::pair{5, 2}));
  EXPECT_EQ(digits("12,50"), (std::pair{2, 4}));
  EXPECT_EQ(digits("-1.250e-03"), (std::pair{6, 4}));
  EXPECT_EQ(digits("2.5E+3"), (std::pair{-2, 2}));
  EXPECT_EQ(digits("0"), (std::pair{0, 0}));
}

TEST(EvenAxis, WholeRatesAreFoundHoweverTheTimesWerePrinted) {
  for (const int rate : {1, 4096, 8192, 44100, 51200, 65536, 1000000}) {
    const auto time = [&](double i) { return i / rate; };
    const std::size_t n = 3000;
    EXPECT_EQ(printed(n, time, significant(17)).step, 1.0 / rate) << rate;
    EXPECT_EQ(printed(n, time, significant(9)).step, 1.0 / rate) << rate;
    EXPECT_EQ(printed(n, time, scientific(6)).step, 1.0 / rate) << rate;
    EXPECT_EQ(printed(n, time, fixed(9)).step, 1.0 / rate) << rate;
  }
}

TEST(EvenAxis, WholeRatesAreFoundInCoarseTimes) {
  // 4096 Hz with four decimals: each time is off by up to a fifth of the step.
  const Axis axis = printed(
      2048, [](double i) { return i / 4096.0; }, fixed(4));
  EXPECT_EQ(axis.step, 1.0 / 4096.0);
  EXPECT_EQ(axis.start, 0.0);
}

TEST(EvenAxis, OtherRatesStayAsTheyAre) {
  const double step = 1e-3 * std::sqrt(2.0);
  const Axis axis = printed(
      1001, [&](double i) { return 5.0 + i * step; }, significant(17));
  EXPECT_EQ(axis.start, 5.0);
  EXPECT_NEAR(axis.step, step, 4e-18) << "an ulp of the last time, 8.9e-16 s, over 1000 steps";
  const Axis close = printed(
      1001, [](double i) { return i / 1000.02; }, significant(17));
  EXPECT_NEAR(1.0 / close.step, 1000.02, 1e-9) << "2e-5 from a whole rate";
}

TEST(EvenAxis, AWholeRateThatDoesNotExplainTheTimesIsNotTaken) {
  // Within 1e-5 of 1000 Hz, but 0.4 steps late after 100 s.
  const auto time = [](double i) { return i / 1000.004; };
  const Axis axis = printed(100001, time, fixed(9));
  ASSERT_TRUE(axis.even());
  EXPECT_NEAR(1.0 / axis.step, 1000.004, 1e-6);
}

TEST(EvenAxis, UnevenTimesStayUneven) {
  const auto gap = [](double i) { return (i < 500.0 ? i : i + 1.0) / 1000.0; };
  EXPECT_FALSE(printed(1000, gap, fixed(6)).even()) << "a sample is missing";
  const auto late_gap = [](double i) { return (i < 998.0 ? i : i + 1.0) / 1000.0; };
  EXPECT_FALSE(printed(1000, late_gap, fixed(3)).even());
  const auto jitter = [](double i) { return (i + 0.01 * std::sin(i * i)) / 1000.0; };
  EXPECT_FALSE(printed(1000, jitter, fixed(6)).even()) << "by 10 units of the last decimal";
  EXPECT_TRUE(printed(1000, jitter, fixed(5)).even()) << "by less than one";
  const auto chirp = [](double i) { return i + 1e-5 * i * i; };
  EXPECT_FALSE(printed(1000, chirp, significant(9)).even());
}

TEST(EvenAxis, WholeNumbersAreNotTakenForRoundedOnes) {
  const auto axis = [](const std::vector<double>& values) {
    PrintedDigits digits;
    for (const double v : values) digits.add(fmt::format("{}", v));
    return axis_from_printed(values, kSecond, digits);
  };
  EXPECT_FALSE(axis({0, 1, 3, 4}).even());
  EXPECT_FALSE(axis({1, 2, 4, 5, 7, 8}).even());
  EXPECT_FALSE(axis({1, 2, 4, 8}).even());
  EXPECT_TRUE(axis({2, 4, 6}).even());
}

struct Clock {
  std::vector<double> times;
  PrintedDigits digits;
};

Clock clock_of(double rate, int decimals, std::size_t count) {
  Clock clock;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text = fmt::format("{:.{}f}", static_cast<double>(i) / rate, decimals);
    clock.digits.add(text);
    clock.times.push_back(std::strtod(text.c_str(), nullptr));
  }
  return clock;
}

// Three digits at 5 kHz make five equal times; four at 5120 Hz steps of one and two. The step is
// that of a line through errors of ulp/√12, whose slope is off by √12/n^1.5 of that: five such.
TEST(RoundedClock, IsEvenByItsWholeSpan) {
  for (const auto& [rate, decimals] :
       {std::pair{5000.0, 3}, {5120.0, 4}, {1024.0, 3}, {51200.0, 4}}) {
    constexpr std::size_t kCount = 400;
    const Clock clock = clock_of(rate, decimals, kCount);
    EXPECT_FALSE(axis_from_printed(clock.times, kSecond, clock.digits).even()) << rate;
    const auto found = axis_of_rounded_clock(clock.times, kSecond, clock.digits);
    ASSERT_TRUE(found) << rate;
    const double ulp = std::pow(10.0, -decimals);
    EXPECT_NEAR(found->axis.step, 1.0 / rate, 5.0 * ulp / std::pow(kCount, 1.5)) << rate;
    EXPECT_NEAR(found->uncertainty, ulp * rate / kCount, 0.1 * found->uncertainty) << rate;
    const auto stated = axis_of_rounded_clock(clock.times, kSecond, clock.digits, 1.0 / rate);
    ASSERT_TRUE(stated) << rate;
    EXPECT_EQ(stated->axis.step, 1.0 / rate);
    EXPECT_FALSE(axis_of_rounded_clock(clock.times, kSecond, clock.digits, 1.05 / rate));
  }
}

TEST(RoundedClock, IsNotWhatIsUneven) {
  Clock clock = clock_of(1000.0, 3, 400);
  for (std::size_t i = 200; i < 400; ++i) clock.times[i] += 1e-3;
  EXPECT_FALSE(axis_of_rounded_clock(clock.times, kSecond, clock.digits)) << "a sample is missing";
  clock = clock_of(5000.0, 3, 400);
  for (std::size_t i = 200; i < 400; ++i) clock.times[i] += 3e-3;
  EXPECT_FALSE(axis_of_rounded_clock(clock.times, kSecond, clock.digits)) << "several";
  clock = clock_of(5000.0, 3, 400);
  std::swap(clock.times[0], clock.times[399]);
  EXPECT_FALSE(axis_of_rounded_clock(clock.times, kSecond, clock.digits)) << "falls";
  clock = clock_of(100.0, 4, 400);
  clock.times[200] = clock.times[199];
  EXPECT_FALSE(axis_of_rounded_clock(clock.times, kSecond, clock.digits)) << "a row is there twice";
  clock = clock_of(5000.0, 3, 19);
  EXPECT_FALSE(axis_of_rounded_clock(clock.times, kSecond, clock.digits)) << "few";
}

TEST(EvenAxis, DigitsCountInTheUnitOfTheFile) {
  PrintedDigits digits;
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) {  // ms with two decimals, 4096 Hz
    const std::string text = fmt::format("{:.2f}", 1000.0 * i / 4096.0);
    digits.add(text);
    values.push_back(std::strtod(text.c_str(), nullptr) / 1000.0);
  }
  const Axis axis = axis_from_printed(values, {.denominator = 1000.0, .dimension = kTime}, digits);
  EXPECT_EQ(axis.step, 1.0 / 4096.0);
}

}  // namespace
}  // namespace microslip::even_axis_test
