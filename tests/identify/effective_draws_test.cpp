// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/effective_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::effective_draws_test {
namespace {

/// x_i = ρx_{i−1} + √(1 − ρ²) z, with an autocorrelation of ρ^k.
std::vector<double> autoregressive(double rho, std::size_t count) {
  RandomStream random(61, 0);
  std::vector<double> values{random.normal()};
  while (values.size() < count) {
    values.push_back(rho * values.back() + std::sqrt(1.0 - rho * rho) * random.normal());
  }
  return values;
}

// n(1 − ρ)/(1 + ρ); of 100 000 draws it is known to some per cent.
TEST(EffectiveDraws, OfAnAutoregressionAreTheKnownShare) {
  constexpr std::size_t kCount = 100'000;
  for (const double rho : {0.0, 0.5, 0.9}) {
    const std::vector<double> values = autoregressive(rho, kCount);
    const double expected = kCount * (1.0 - rho) / (1.0 + rho);
    EXPECT_NEAR(effective_draws(values, kCount), expected, 0.1 * expected) << rho;
    EXPECT_NEAR(effective_draws(values, 2'000), expected, 0.1 * expected) << rho;
  }
}

// Chains that each stand still, elsewhere: no more than there are chains.
TEST(EffectiveDraws, OfChainsThatStandStillAreAsManyAsThese) {
  std::vector<double> values;
  for (int chain = 0; chain < 4; ++chain) values.insert(values.end(), 50, 1.0 * chain);
  EXPECT_LE(effective_draws(values, 50), 4.0 * 1.1);
}

TEST(EffectiveDraws, OfEqualDrawsAreAll) {
  EXPECT_EQ(effective_draws(std::vector<double>(30, 2.0), 10), 30.0);
}

}  // namespace
}  // namespace microslip::effective_draws_test
