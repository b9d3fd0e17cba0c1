// SPDX-License-Identifier: MIT
#include "microslip/joint/fixed_power.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

FixedPower::FixedPower(double exponent, double most) {
  constexpr int kBias = 1023;
  constexpr double kLeastTabulated = 1e-280;
  constexpr double kMostTabulated = 1e280;
  if (!(exponent > 0.0 && exponent <= 8.0) || !(most > 0.0 && most <= kMostTabulated)) return;
  const int highest = std::ilogb(most);
  const int lowest = std::max(highest - static_cast<int>(kOctaves) + 1, 1 - kBias);
  const double smallest = std::pow(std::ldexp(1.0, lowest), exponent);
  const double largest = std::pow(2.0 * most, exponent);
  if (!(smallest >= kLeastTabulated && largest <= kMostTabulated)) return;
  least_ = std::ldexp(1.0, lowest);
  most_ = most;
  lowest_octave_ = static_cast<std::size_t>(lowest + kBias);
  for (int e = lowest; e <= highest; ++e) {
    octave_[static_cast<std::size_t>(e - lowest)] = std::pow(std::ldexp(1.0, e), exponent);
  }
  for (std::size_t i = 0; i < kIntervals; ++i) {
    interval_[i] = std::pow(middle(i), exponent);
    inverse_[i] = 1.0 / middle(i);
  }
  double binomial = 1.0;
  for (std::size_t n = 0; n < series_.size(); ++n) {
    const auto order = static_cast<double>(n);
    binomial *= (exponent - order) / (order + 1.0);
    series_[n] = binomial;
  }
}

}  // namespace microslip
