// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/spread_prior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace microslip {
namespace {

/// Number of steps of ln σ: 3 % each, far below the accuracy from few assemblies.
constexpr std::size_t kCells = 400;

}  // namespace

double SpreadPrior::log_density(double log_spread) {
  const double spread = std::exp(log_spread);
  if (!(spread >= kLeast && spread <= kMost)) return -std::numeric_limits<double>::infinity();
  const double share = spread / kUsual;
  return log_spread - std::log(kNone + spread) - std::log1p(share * share);
}

double SpreadPrior::draw(double count, double square, RandomStream& random) {
  const double first = std::log(kLeast);
  const double cell = (std::log(kMost) - first) / static_cast<double>(kCells);
  const auto middle = [&](std::size_t i) { return first + cell * (static_cast<double>(i) + 0.5); };
  std::array<double, kCells> density{};
  for (std::size_t i = 0; i < kCells; ++i) {
    const double log_spread = middle(i);
    density[i] =
        log_density(log_spread) - count * log_spread - 0.5 * square * std::exp(-2.0 * log_spread);
  }
  const double largest = *std::ranges::max_element(density);
  double sum = 0.0;
  for (double& value : density) {
    sum += std::exp(value - largest);
    value = sum;
  }
  const double wanted = random.uniform() * sum;
  const auto found =
      static_cast<std::size_t>(std::ranges::lower_bound(density, wanted) - density.begin());
  const std::size_t index = std::min(found, kCells - 1);
  return std::exp(middle(index) + cell * (random.uniform() - 0.5));
}

}  // namespace microslip
