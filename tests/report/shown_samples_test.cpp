// SPDX-License-Identifier: MIT
#include "microslip/report/figures/shown_samples.hpp"

#include "microslip/base/gather.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip::shown_samples_test {
namespace {

/// Cycles of a sine, with a spike in the force.
ForcePath record(std::size_t samples, double cycles) {
  ForcePath path{.source = "a.csv", .reversals = static_cast<std::size_t>(2.0 * cycles)};
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(samples);
    const double grown = t < 0.7 ? t : 1.4 - t;
    path.time.push_back(t);
    path.path.push_back(grown * std::sin(2.0 * std::numbers::pi * cycles * t));
    path.displacement.push_back(path.path.back());
    path.force.push_back(2.0 * path.path.back());
    path.found.push_back(2.0 * path.path.back());
  }
  path.force[samples / 3] += 5.0;
  return path;
}

TEST(ShownSamples, AreAllOfAShortRecord) {
  const ForcePath path = record(500, 10.0);
  EXPECT_EQ(shown_samples(path, {0, 500}, 500).size(), 500U);
  EXPECT_EQ(shown_samples(path, {100, 200}, 500).front(), 100U);
  EXPECT_EQ(shown_samples(path, {100, 200}, 500).back(), 199U);
}

TEST(ShownSamples, KeepWhatStandsOut) {
  constexpr std::size_t kCount = 1'000'000;
  const ForcePath path = record(kCount, 40.0);
  const std::vector<std::size_t> samples = shown_samples(path, {0, kCount}, 4000);
  EXPECT_LE(samples.size(), 4000U);
  EXPECT_GE(samples.size(), 1000U);
  EXPECT_TRUE(std::ranges::is_sorted(samples));
  EXPECT_TRUE(std::ranges::binary_search(samples, kCount / 3)) << "the spike";
  for (const auto* values : {&path.displacement, &path.force, &path.found}) {
    const std::vector<double> shown = gather(*values, samples);
    EXPECT_EQ(std::ranges::max(shown), std::ranges::max(*values));
    EXPECT_EQ(std::ranges::min(shown), std::ranges::min(*values));
  }
}

TEST(ShownSamples, GoOnWhereNothingIsKnownOfTheJoint) {
  ForcePath path = record(10000, 10.0);
  std::fill_n(path.found.begin(), 2000, std::numeric_limits<double>::quiet_NaN());
  const std::vector<std::size_t> samples = shown_samples(path, {0, 10000}, 400);
  EXPECT_LT(samples.front(), 200U);
  EXPECT_TRUE(std::isnan(residual_of(path).front()));
}

TEST(ShownSamples, OfLoopsAreAPartWhereThereAreManyCycles) {
  const ForcePath few = record(100'000, 20.0);
  EXPECT_EQ(part_for_loops(few, 4000).begin, 0U);
  EXPECT_EQ(part_for_loops(few, 4000).end, 100'000U);
  const ForcePath many = record(100'000, 1000.0);
  const RecordPart part = part_for_loops(many, 4000);
  EXPECT_GE(part.end - part.begin, 4000U);
  EXPECT_LT(part.end - part.begin, 20'000U);
  // The largest displacement is at 70 % of the time.
  EXPECT_LT(part.begin, 70'000U);
  EXPECT_GT(part.end, 70'000U);
}

}  // namespace
}  // namespace microslip::shown_samples_test
