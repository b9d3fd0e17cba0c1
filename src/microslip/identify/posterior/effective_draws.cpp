// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/effective_draws.hpp"

#include <algorithm>

namespace microslip {
namespace {

/// Draws that are equal differ from their mean by rounding.
constexpr double kOfEqualDraws = 1e-24;

/// Correlation of deviations from the mean of all, `lag` apart, within chains.
double autocovariance(std::span<const double> draws, std::size_t chain, double mean,
                      std::size_t lag) {
  double sum = 0.0;
  for (std::size_t begin = 0; begin < draws.size(); begin += chain) {
    const std::size_t end = std::min(begin + chain, draws.size());
    for (std::size_t i = begin + lag; i < end; ++i) {
      sum += (draws[i] - mean) * (draws[i - lag] - mean);
    }
  }
  return sum / static_cast<double>(draws.size());
}

}  // namespace

double effective_draws(std::span<const double> draws, std::size_t chain) {
  const auto count = static_cast<double>(draws.size());
  double mean = 0.0;
  for (const double value : draws) mean += value / count;
  const double variance = autocovariance(draws, chain, mean, 0);
  if (!(variance > kOfEqualDraws * mean * mean)) return count;
  double sum = 1.0;
  for (std::size_t lag = 1; lag + 1 < std::min(chain, draws.size()); lag += 2) {
    const double pair =
        autocovariance(draws, chain, mean, lag) + autocovariance(draws, chain, mean, lag + 1);
    if (pair <= 0.0) break;
    sum += 2.0 * pair / variance;
  }
  return std::min(count, count / sum);
}

}  // namespace microslip
