// SPDX-License-Identifier: MIT
#include "microslip/observe/smoothed_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::smoothed_path_test {
namespace {

/// A sum of sines below 6 % of the sampling rate, of rms near 1, which neither begins nor ends at
/// rest.
std::vector<double> slow_path(std::size_t count, std::uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> path(count, 0.0);
  constexpr int kSines = 12;
  for (int j = 0; j < kSines; ++j) {
    const double cycles = 0.06 * random.uniform();
    const double phase = 2.0 * std::numbers::pi * random.uniform();
    for (std::size_t i = 0; i < count; ++i) {
      path[i] += std::sqrt(2.0 / kSines) *
                 std::sin(2.0 * std::numbers::pi * cycles * static_cast<double>(i) + phase);
    }
  }
  return path;
}

std::vector<double> with_noise(std::vector<double> path, double deviation, std::uint64_t seed) {
  RandomStream random(seed, 1);
  for (double& value : path) value += deviation * random.normal();
  return path;
}

/// Root mean square of the difference from the first to the last sample but `skip`.
double distance(const std::vector<double>& a, const std::vector<double>& b, std::size_t skip) {
  double sum = 0.0;
  for (std::size_t i = skip; i + skip < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size() - 2 * skip));
}

// The upper quarter of the spectrum has a thousand lines: their median power is good to 1.4/√1000,
// its root to half of that, 2.2 %; 7 % is three of these. Below 3e-4 the ends of the path leak into
// it.
TEST(SmoothedPath, FindsTheNoise) {
  for (const double noise : {3e-4, 1e-3, 1e-2}) {
    const SmoothedPath found = smooth_path(with_noise(slow_path(8000, 3), noise, 4));
    EXPECT_NEAR(found.noise / noise, 1.0, 0.07) << noise;
  }
}

// White noise in the 6 % of the band that the path fills is a quarter of all of it; where the ends
// of the path leak above it, more is kept.
TEST(SmoothedPath, KeepsThePathAndLittleOfTheNoise) {
  const std::vector<double> truth = slow_path(8000, 5);
  for (const double noise : {1e-3, 1e-2}) {
    const SmoothedPath found = smooth_path(with_noise(truth, noise, 6));
    const double left = distance(found.displacement, truth, 200);
    EXPECT_LT(left, 0.7 * noise);
    EXPECT_NEAR(found.left / left, 1.0, 0.3) << noise;
  }
}

TEST(SmoothedPath, KeepsThePathAtItsEndsToTheNoise) {
  const std::vector<double> truth = slow_path(8000, 7);
  const SmoothedPath found = smooth_path(with_noise(truth, 1e-3, 8));
  for (const std::size_t i : {std::size_t{0}, truth.size() - 1}) {
    EXPECT_NEAR(found.displacement[i], truth[i], 5e-3) << i;
  }
}

// A triangle of 100 samples a branch, its corners between them. A filter alone rounds them by an
// eighth of the change of the velocity times the samples that it takes together.
TEST(SmoothedPath, KeepsCorners) {
  constexpr double kBranch = 100.3;
  std::vector<double> truth;
  for (int i = 0; i < 3000; ++i) {
    truth.push_back(2.0 / std::numbers::pi * std::asin(std::sin(std::numbers::pi * i / kBranch)));
  }
  for (const double noise : {1e-4, 1e-3, 1e-2}) {
    const SmoothedPath found = smooth_path(with_noise(truth, noise, 11));
    EXPECT_NEAR(found.noise / noise, 1.0, 0.1) << noise;
    EXPECT_EQ(found.corners.size(), 30U) << noise;
    double largest = 0.0;
    for (std::size_t i = 200; i + 200 < truth.size(); ++i) {
      largest = std::max(largest, std::abs(found.displacement[i] - truth[i]));
    }
    EXPECT_LE(largest, 3.0 * noise);
  }
}

TEST(SmoothedPath, LeavesAPathWithoutNoise) {
  const std::vector<double> truth = slow_path(4096, 9);
  const SmoothedPath found = smooth_path(truth);
  EXPECT_LT(distance(found.displacement, truth, 0), 1e-4);
}

TEST(SmoothedPath, LeavesAPathThatFillsItsSpectrum) {
  RandomStream random(10, 0);
  std::vector<double> truth;
  for (int i = 0; i < 4096; ++i) truth.push_back(random.normal());
  // Nothing stands out: all of it may be noise, and `left` states that the kept part is as
  // uncertain.
  const SmoothedPath found = smooth_path(truth);
  EXPECT_NEAR(found.noise, 1.0, 0.1);
}

}  // namespace
}  // namespace microslip::smoothed_path_test
