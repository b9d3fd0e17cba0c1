// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/serial_correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::serial_correlation_test {
namespace {

// By hand: differences −2, 2, …: v = 4.
TEST(SerialCorrelation, IsNegativeWhereSignsAlternate) {
  const std::vector<double> residuals{1, -1, 1, -1, 1, -1, 1, -1, 1, -1};
  const SerialCorrelation found = serial_correlation(residuals);
  EXPECT_NEAR(found.correlation, -1.0, 1e-15);
  EXPECT_NEAR(found.deviations, found.correlation * std::sqrt(99.0 / 8.0), 1e-14);
}

TEST(SerialCorrelation, IsNearOneOfASlowWave) {
  std::vector<double> residuals;
  for (int i = 0; i < 90; ++i) residuals.push_back(std::sin(2.0 * std::acos(-1.0) * i / 90.0));
  EXPECT_GT(serial_correlation(residuals).correlation, 0.99);
  EXPECT_GT(serial_correlation(residuals).deviations, 9.0);
}

// The standard deviation of the standard deviation of 4000 values is 1.1 %, so 5 % are 4.5 of them.
TEST(SerialCorrelation, HasTheDeviationOfWhiteNoise) {
  constexpr int kDraws = 4000;
  double sum = 0.0;
  double squares = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    RandomStream random(11, static_cast<std::uint64_t>(draw));
    std::vector<double> residuals;
    for (int i = 0; i < 40; ++i) residuals.push_back(random.normal());
    const double z = serial_correlation(residuals).deviations;
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 5.0 / std::sqrt(kDraws));
  EXPECT_NEAR(std::sqrt(squares / kDraws), 1.0, 0.05);
}

TEST(SerialCorrelation, IsNothingOfFewOrOfNone) {
  EXPECT_EQ(serial_correlation(std::vector<double>(7, 1.0)).deviations, 0.0);
  EXPECT_EQ(serial_correlation(std::vector<double>(20, 0.0)).deviations, 0.0);
}

}  // namespace
}  // namespace microslip::serial_correlation_test
