// SPDX-License-Identifier: MIT
#include "microslip/observe/path_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/record_rows.hpp"
#include "support/force_records.hpp"
#include "support/random_path.hpp"

namespace microslip::path_rows_test {
namespace {

constexpr double kLength = 1e-4;    // X, m
constexpr double kStiffness = 3e5;  // k = k₀, N/m
constexpr std::size_t kAllRows = 1'000'000'000;

const std::vector<double> kKnots{0.02, 0.1, 0.3, 0.7, 1.0};
const std::vector<double> kDensity{0.9, 1.1, 0.4, 1.0, 0.3};  // p at the knots: area 0.7

/// The same density as a joint, whose Memory follows other rules than the rows: a stack of forces.
Joint joint() {
  PiecewiseLinearPart part;
  part.slip_force.push_back(0.0);
  part.density.push_back(kDensity.front() / (kStiffness * kLength));
  for (std::size_t j = 0; j < kKnots.size(); ++j) {
    part.slip_force.push_back(kStiffness * kLength * kKnots[j]);
    part.density.push_back(kDensity[j] / (kStiffness * kLength));
  }
  return {kStiffness, SlipDensity({part})};
}

double remainder_of(const Joint& joint) {
  return joint.stiffness() * joint.density().elastic_remainder();
}

/// The force of the density by the rows, N.
std::vector<double> predicted(const PathRows& path, const Joint& joint) {
  const Eigen::MatrixXd rows = stop_rows(path, kLength, kKnots);
  const Eigen::VectorXd p = Eigen::Map<const Eigen::VectorXd>(
      kDensity.data(), static_cast<Eigen::Index>(kDensity.size()));
  const Eigen::VectorXd scaled = kStiffness * kLength * (rows * p);
  std::vector<double> force;
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    force.push_back(scaled(static_cast<Eigen::Index>(i)) +
                    remainder_of(joint) * path.rows[i].displacement);
  }
  return force;
}

/// The path between its samples, so that rows have some.
std::vector<double> refined(const std::vector<double>& path, std::size_t pieces) {
  std::vector<double> fine = {path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (std::size_t j = 1; j <= pieces; ++j) {
      const double share = static_cast<double>(j) / static_cast<double>(pieces);
      fine.push_back(path[i - 1] + share * (path[i] - path[i - 1]));
    }
  }
  return fine;
}

std::vector<double> from_zero(std::vector<double> path) {
  path.insert(path.begin(), 0.0);
  return path;
}

// Rounding of forces of 10 N over sums of some hundred stretches.
TEST(PathRows, OfAVirginJointAreTheForcesOfItsMemory) {
  const Joint truth = joint();
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const std::vector<double> path = from_zero(testing::random_path(seed, 400, 1.5 * kLength, 4));
    const std::vector<double> force = testing::forces_on(truth, path);
    const PathRows rows = path_rows(path, force, PathStart::kVirgin, 0.0, kAllRows);
    const std::vector<double> found = predicted(rows, truth);
    EXPECT_EQ(rows.groups, 1U);
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      ASSERT_NEAR(found[i], rows.rows[i].force, 2e-11) << "seed " << seed << " row " << i;
    }
  }
}

TEST(PathRows, HaveEverySampleOnce) {
  const std::vector<double> path = refined(from_zero(testing::random_path(7, 100, kLength, 3)), 20);
  const PathRows rows = path_rows(path, path, PathStart::kVirgin, 0.0, 500);
  std::size_t next = 0;
  for (const PathRow& row : rows.rows) {
    EXPECT_EQ(row.first, next);
    next += row.count;
  }
  EXPECT_EQ(next, path.size());
}

// Rounding of forces of 10 N, though rows are up to a third of the range long.
TEST(PathRows, OfSeveralSamplesAreTheirMeanForces) {
  const Joint truth = joint();
  const std::vector<double> path =
      refined(from_zero(testing::random_path(11, 60, 0.9 * kLength, 1)), 300);
  const std::vector<double> force = testing::forces_on(truth, path);
  for (const std::size_t most : {50U, 2000U}) {
    const PathRows rows = path_rows(path, force, PathStart::kVirgin, 0.0, most);
    const std::vector<double> found = predicted(rows, truth);
    EXPECT_LT(5 * rows.rows.size(), path.size());
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      ASSERT_NEAR(found[i], rows.rows[i].force, 2e-11) << "row " << i << " of " << most;
    }
  }
}

// A thousand equal cycles: rows of 6000 would all be a third of a branch.
TEST(PathRows, AreShortOnSomeBranchesOfMany) {
  std::vector<double> path;
  for (int i = 0; i < 200'000; ++i) path.push_back(std::sin(2.0 * std::numbers::pi * i / 200.0));
  const PathRows rows = path_rows(path, path, PathStart::kVirgin, 1e-9, 6000);
  EXPECT_LT(rows.rows.size(), 30'000U);
  std::size_t short_rising = 0;
  std::size_t short_falling = 0;
  for (std::size_t i = 1; i + 1 < rows.rows.size(); ++i) {
    const PathRow& row = rows.rows[i];
    const double length = std::abs(path[row.first] - path[row.first + row.count - 1]);
    ASSERT_EQ(row.turns == rows.rows[i - 1].turns,
              row.last.coefficient == rows.rows[i - 1].last.coefficient);
    if (std::abs(row.displacement) > 0.1 || length > 2.0 / 60.0) continue;
    (row.velocity > 0.0 ? short_rising : short_falling) += 1;
  }
  EXPECT_GT(short_rising, 100U);
  EXPECT_GT(short_falling, 100U);
}

// Before the record the joint moved arbitrarily, within half the range that the record then has.
TEST(PathRows, FromAnUnknownStateDifferByAConstantInEachGroup) {
  const Joint truth = joint();
  for (const std::uint64_t seed : {21U, 22U, 23U}) {
    std::vector<double> whole = from_zero(testing::random_path(seed, 40, 0.4 * kLength, 3));
    const std::size_t before = whole.size();
    const std::vector<double> later = testing::random_path(seed + 100, 400, 1.3 * kLength, 3);
    whole.insert(whole.end(), later.begin(), later.end());
    const std::vector<double> forces = testing::forces_on(truth, whole);
    const auto skip = static_cast<std::ptrdiff_t>(before);
    const std::vector<double> path(whole.begin() + skip, whole.end());
    const std::vector<double> force(forces.begin() + skip, forces.end());

    const PathRows rows = path_rows(path, force, PathStart::kUnknown, 0.0, kAllRows);
    const std::vector<double> found = predicted(rows, truth);
    ASSERT_GT(rows.rows.size(), path.size() / 4);
    std::vector<double> offset(rows.groups, std::nan(""));
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      const PathRow& row = rows.rows[i];
      double& of_group = offset[row.group];
      const double left = row.force - found[i];
      if (std::isnan(of_group)) of_group = left;
      ASSERT_NEAR(left, of_group, 3e-11) << "seed " << seed << " sample " << row.first;
    }
  }
}

// The first sample lies at the origin, on neither side of it.
TEST(PathRows, BeginOnTheSideThatTheMotionGoesTo) {
  for (const double direction : {1.0, -1.0}) {
    std::vector<double> path;
    for (int i = 0; i <= 400; ++i) path.push_back(direction * i);
    for (int i = 400; i >= -400; --i) path.push_back(direction * i);
    const PathRows rows = path_rows(path, path, PathStart::kVirgin, 0.0, 100);
    const PathRow& first = rows.rows.front();
    ASSERT_GT(first.count, 1U);
    EXPECT_EQ(first.last.coefficient, direction);
    EXPECT_DOUBLE_EQ(first.last.coefficient * first.last.half_range, first.displacement);
  }
}

// A path at constant speed, sampled beside its turns: the turn at a corner is where the path was,
// so that rows are the forces on that path, of which every tenth place is a sample. Rounding as
// above.
TEST(PathRows, TurnAtCornersBetweenSamples) {
  const Joint truth = joint();
  std::vector<double> whole = {0.0};
  std::vector<PathCorner> corners;
  constexpr double kStep = kLength / 1000.0;
  double direction = 1.0;
  for (const int steps : {1003, 1809, 1507, 702, 1204}) {
    for (int i = 0; i < steps; ++i) whole.push_back(whole.back() + direction * kStep);
    corners.push_back({0.1 * static_cast<double>(whole.size() - 1), -20.0 * direction * kStep});
    direction = -direction;
  }
  corners.pop_back();
  const std::vector<double> all = testing::forces_on(truth, whole);
  std::vector<double> path;
  std::vector<double> force;
  for (std::size_t i = 0; i < whole.size(); i += 10) {
    path.push_back(whole[i]);
    force.push_back(all[i]);
  }
  const PathRows rows = path_rows(path, force, PathStart::kVirgin, 0.0, kAllRows, corners);
  const std::vector<double> found = predicted(rows, truth);
  EXPECT_EQ(rows.reversals, 4U);
  std::size_t samples = 0;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    samples += rows.rows[i].count;
    ASSERT_NEAR(found[i], rows.rows[i].force, 2e-11) << "row " << i;
  }
  EXPECT_EQ(samples, path.size());
}

// The largest of 60 errors is 2.3 deviations: k would be too small by as much, over the first of
// what slips. Their parabola is good to 1.5/√60 of one; three of these.
TEST(PathRows, TurnAtTheLevelOfANoisyHold) {
  constexpr double kNoise = 1e-2;
  RandomStream random(6, 0);
  std::vector<double> path;
  for (int i = 0; i < 50; ++i) path.push_back(i / 50.0);
  for (int i = 0; i < 60; ++i) path.push_back(1.0 + kNoise * random.normal());
  for (int i = 0; i < 50; ++i) path.push_back(1.0 - i / 50.0);
  const std::vector<double> force(path.size(), 0.0);
  const PathRows rows = path_rows(path, force, PathStart::kVirgin, 6.0 * kNoise, 6000);
  ASSERT_EQ(rows.turns.back().size(), 1U);
  EXPECT_NEAR(rows.turns.back().front().half_range, 1.0, 3.0 * 1.5 * kNoise / std::sqrt(60.0));
}

TEST(PathRows, HoldSmallTurnsTogether) {
  // A rise of 100 with turns of 1 on it.
  std::vector<double> path;
  for (int i = 0; i <= 400; ++i) path.push_back(0.25 * i + (i % 8 < 4 ? 0.0 : -1.0));
  for (int i = 0; i <= 400; ++i) path.push_back(100.0 - 0.25 * i);
  const PathRows all = path_rows(path, path, PathStart::kVirgin, 0.0, 1000);
  const PathRows merged = path_rows(path, path, PathStart::kVirgin, 2.0, 1000);
  EXPECT_GT(all.reversals, 90U);
  EXPECT_EQ(merged.reversals, 1U);
  EXPECT_DOUBLE_EQ(merged.reach, 100.0);
}

}  // namespace
}  // namespace microslip::path_rows_test
