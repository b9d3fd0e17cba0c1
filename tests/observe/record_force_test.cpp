// SPDX-License-Identifier: MIT
// The force of a joint along the path of a record.

#include "microslip/observe/record_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "support/force_records.hpp"

namespace microslip::record_force_test {
namespace {

constexpr double kReach = 2.4e-4;  // m
constexpr double kStep = 1e-3;     // s

Joint known_joint() {
  return {1.7e5, SlipDensity({UniformPart{.from = 0.0, .to = 60.0, .weight = 0.8}})};
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b,
                          std::size_t from = 0) {
  double largest = 0.0;
  for (std::size_t i = from; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The path of the evidence, from where the joint is virgin.
std::vector<double> from_rest(const RecordEvidence& evidence) {
  std::vector<double> path = evidence.path().displacement;
  const double first = path.front();
  for (double& u : path) u -= first;
  return path;
}

// Memory uses another algorithm: it keeps turns and evaluates the branch. Both use the same path;
// the difference is rounding, of ignored turns, too.
TEST(RecordForce, IsThatOfTheJointAtEachSample) {
  const std::vector<double> path = testing::random_motion(4000, kReach, 3);
  const RecordEvidence smoothed({path, testing::forces_on(known_joint(), path), kStep},
                                PathStart::kVirgin);
  std::vector<double> force = testing::forces_on(known_joint(), from_rest(smoothed));
  const double largest = std::ranges::max(force);
  for (double& value : force) value += 7.0;  // an offset
  const RecordEvidence evidence({path, force, kStep}, PathStart::kVirgin);
  EXPECT_LE(largest_difference(found_force(evidence, known_joint(), 0.0), force), 1e-9 * largest);
}

TEST(RecordForce, HasAViscousPart) {
  const std::vector<double> path = testing::random_motion(4000, kReach, 3);
  const RecordEvidence evidence({path, testing::forces_on(known_joint(), path), kStep},
                                PathStart::kVirgin);
  const std::vector<double> moved = from_rest(evidence);
  constexpr double kViscous = 30.0;  // N s/m
  const std::vector<double> with = found_force(evidence, known_joint(), kViscous);
  const std::vector<double> without = found_force(evidence, known_joint(), 0.0);
  std::vector<double> expected;
  std::vector<double> difference;
  double mean = 0.0;  // goes into the offset
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    expected.push_back(kViscous * (moved[i + 1] - moved[i - 1]) / (2.0 * kStep));
    difference.push_back(with[i] - without[i]);
    mean += (difference.back() - expected.back()) / static_cast<double>(path.size() - 2);
  }
  for (double& value : difference) value -= mean;
  EXPECT_LE(largest_difference(difference, expected), 1e-9 * std::ranges::max(expected));
}

// A joint that had slipped before: the force is unknown until the path has turned, and known from
// its largest range on.
TEST(RecordForce, IsUnknownBeforeTheFirstTurnOfASlippedJoint) {
  const std::vector<double> whole = testing::random_motion(6000, kReach, 4);
  const std::vector<double> all = testing::forces_on(known_joint(), whole);
  const std::vector<double> path(whole.begin() + 3000, whole.end());
  const std::vector<double> force(all.begin() + 3000, all.end());
  const RecordEvidence evidence({path, force, kStep}, PathStart::kUnknown);
  const std::vector<double> found = found_force(evidence, known_joint(), 0.0);
  EXPECT_TRUE(std::isnan(found.front()));
  const auto [low, high] = std::ranges::minmax_element(path);
  const auto grown = static_cast<std::size_t>(std::max(low, high) - path.begin());
  ASSERT_LT(grown + 100, path.size());
  EXPECT_LE(largest_difference(found, force, grown + 1), 1e-3 * std::ranges::max(force));
}

}  // namespace
}  // namespace microslip::record_force_test
