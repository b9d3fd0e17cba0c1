// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/quantiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::quantiles_test {
namespace {

TEST(Quantiles, LeaveAsManyBelowAsAbove) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  const auto [lower, upper] = quantile_pair(values, 0.9);
  EXPECT_NEAR(lower, 5.0, 1e-12);
  EXPECT_NEAR(upper, 95.0, 1e-12);
  EXPECT_NEAR(quantile(values, 0.255), 25.5, 1e-12);
}

// |z| is below 1.96 with a probability of 0.95, and between 0.03 and 2.24, which is wider.
TEST(Quantiles, BeginAtZeroWhereThatIsNarrower) {
  RandomStream random(71, 0);
  std::vector<double> half;
  std::vector<double> far;
  for (int i = 0; i < 100'000; ++i) {
    half.push_back(std::abs(random.normal()));
    far.push_back(5.0 + random.normal());
  }
  const auto [from, to] = quantile_pair_above_zero(half, 0.95);
  EXPECT_EQ(from, 0.0);
  EXPECT_NEAR(to, 1.96, 0.03);
  const std::pair<double, double> between = quantile_pair_above_zero(far, 0.95);
  EXPECT_EQ(between, quantile_pair(far, 0.95));
}

// |z| is densest at 0; quantile_pair() begins at 0.03.
TEST(Quantiles, OfTheShortestIntervalGoOnToALimit) {
  RandomStream random(72, 0);
  std::vector<double> pressed;
  std::vector<double> free;
  for (int i = 0; i < 100'000; ++i) {
    pressed.push_back(7.0 - std::abs(random.normal()));
    free.push_back(random.normal());
  }
  const auto [from, to] = shortest_interval(pressed, 0.95);
  EXPECT_NEAR(from, 7.0 - 1.96, 0.03);
  EXPECT_NEAR(to, 7.0, 1e-3);
  const auto [lower, upper] = shortest_interval(free, 0.95);
  EXPECT_NEAR(upper - lower, 2.0 * 1.96, 0.03);
  EXPECT_NEAR(upper + lower, 0.0, 0.3);  // the width has a flat minimum
}

}  // namespace
}  // namespace microslip::quantiles_test
