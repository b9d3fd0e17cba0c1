// SPDX-License-Identifier: MIT
#include "microslip/observe/path_corners.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "support/force_records.hpp"

namespace microslip::path_corners_test {
namespace {

/// A path through values at places between samples, straight from one to the next.
struct Vertex {
  double at;
  double value;
};

std::vector<double> through(const std::vector<Vertex>& vertices, double noise = 0.0,
                            std::uint64_t seed = 1) {
  RandomStream random(seed, 3);
  std::vector<double> path;
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    const Vertex& from = vertices[v - 1];
    const Vertex& to = vertices[v];
    for (auto i = static_cast<double>(path.size()); i < to.at; ++i) {
      const double share = (i - from.at) / (to.at - from.at);
      path.push_back(from.value + share * (to.value - from.value) + noise * random.normal());
    }
  }
  return path;
}

/// Turns at no sample, and a hold.
const std::vector<Vertex> kBench{{0.0, 0.0},     {100.3, 1.0}, {300.6, -1.0}, {340.2, -1.0},
                                 {541.5, 1.0},   {600.0, 1.0}, {700.4, 0.0},  {750.0, 0.5},
                                 {850.25, -0.5}, {900.0, 0.0}};

double velocity(std::size_t to) {
  return (kBench[to].value - kBench[to - 1].value) / (kBench[to].at - kBench[to - 1].at);
}

// Two straight lines through n samples meet within some 4σ/√n of their place, over the change of
// the velocity; here with 40 to 100 samples a side, and five of these deviations.
TEST(PathCorners, AreFoundBetweenSamples) {
  for (const double noise : {0.0, 1e-4, 1e-3, 5e-3}) {
    const std::vector<PathCorner> found = path_corners(through(kBench, noise));
    ASSERT_EQ(found.size(), kBench.size() - 2) << noise;
    for (std::size_t v = 1; v + 1 < kBench.size(); ++v) {
      const double change = velocity(v + 1) - velocity(v);
      const PathCorner& corner = found[v - 1];
      EXPECT_NEAR(corner.at, kBench[v].at,
                  1e-6 + 20.0 * noise / std::sqrt(40.0) / std::abs(change));
      EXPECT_NEAR(corner.change, change, 1e-8 + 20.0 * noise / std::pow(40.0, 1.5));
    }
  }
}

// Ramps with holds: a window that sees a corner in noise as large as its change of the velocity
// has the other end of the hold in it.
TEST(PathCorners, AreFoundBesideOthers) {
  const std::vector<Vertex> ramps{{0.0, 0.0},    {100.0, 1.0}, {166.7, 1.0}, {366.7, -1.0},
                                  {433.4, -1.0}, {633.4, 1.0}, {700.1, 1.0}, {900.1, -1.0},
                                  {966.8, -1.0}, {1066.8, 0.0}};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_EQ(path_corners(through(ramps, 1e-2, seed)).size(), ramps.size() - 2) << seed;
  }
}

// Sines, motions of a band of frequencies, and an earthquake. Those of the reference "sines", whose
// amplitude changes from one cycle to the next, have corners there.
TEST(PathCorners, AreNoneOfSmoothPaths) {
  for (const double noise : {0.0, 1e-4, 1e-3, 1e-2}) {
    RandomStream random(5, 0);
    for (const double per_cycle : {40.0, 333.3, 4000.0}) {
      std::vector<double> path;
      for (int i = 0; i < 10'000; ++i) {
        path.push_back(std::sin(2.0 * std::numbers::pi * i / per_cycle) + noise * random.normal());
      }
      EXPECT_EQ(path_corners(path).size(), 0U) << noise << ' ' << per_cycle;
    }
    // It stops to grow after a fifth: a corner.
    std::vector<double> motion = testing::random_motion(10'000, 1.0, 6);
    motion.erase(motion.begin(), motion.begin() + 2'500);
    for (double& u : motion) u += noise * random.normal();
    EXPECT_EQ(path_corners(motion).size(), 0U) << noise;
  }
  for (const std::string name : {"random", "earthquake"}) {
    EXPECT_EQ(path_corners(testing::reference_record(name).displacement).size(), 0U) << name;
  }
}

TEST(PathCorners, AreNoneOfNoise) {
  RandomStream random(7, 0);
  std::vector<double> path;
  for (int i = 0; i < 100'000; ++i) path.push_back(random.normal());
  EXPECT_EQ(path_corners(path).size(), 0U);
}

TEST(PathCorners, AreNoneOfShortPaths) {
  EXPECT_EQ(path_corners(std::vector<double>(16, 1.0)).size(), 0U);
}

// Triangles that grow, turning midway between two samples, written with nine digits: two places
// that were seen moved to one corner, and the window between them had no end (a segmentation
// fault).
TEST(PathCorners, AreOnceEachWhereTheyAreRounded) {
  constexpr int kTurns = 20;
  std::vector<Vertex> growing{{0.0, 0.0}};
  for (int turn = 0; turn < kTurns; ++turn) {
    const double at = 37.5 + 75.0 * turn;
    const double size = std::max(0.06, at / 1500.0);
    growing.push_back({at, turn % 2 == 0 ? size : -size});
  }
  growing.push_back({1500.0, 0.0});
  for (const double scale :
       {1.820740099571985e-06, 2.7148547265657925e-06, 4.943044865170874e-06}) {
    std::vector<double> path = through(growing);
    for (double& value : path) value = std::stod(fmt::format("{:.8e}", scale * value));
    EXPECT_EQ(path_corners(path).size(), static_cast<std::size_t>(kTurns)) << scale;
  }
}

// The part of a corner has its jump of the velocity, and none of a derivative elsewhere.
TEST(PathCorners, HaveAPartThatIsSmoothBesideThem) {
  const PathCorner corner{10.0, 0.3};
  constexpr double kReach = 20.0;
  EXPECT_DOUBLE_EQ(corner.value(2.0, kReach), 0.3);
  EXPECT_DOUBLE_EQ(corner.value(-2.0, kReach), 0.3);
  EXPECT_EQ(corner.value(kReach, kReach), 0.0);
  for (const double t : {5.0, 12.0, 20.0}) {
    constexpr double kStep = 1e-3;
    const double before = corner.value(t, kReach) - corner.value(t - kStep, kReach);
    const double after = corner.value(t + kStep, kReach) - corner.value(t, kReach);
    EXPECT_NEAR(before, after, 1e-6 * 0.3) << t;
  }
}

// Nested springs of a finite-element code turn over two steps, half as long as the others: a corner
// there would lie beyond each of them, where the springs never were.
TEST(PathCorners, RoundedOverASampleAreNone) {
  std::vector<double> path{0.0};
  for (int turn = 0; turn < 4; ++turn) {
    const double step = turn % 2 == 0 ? 2e-4 : -2e-4;
    path.push_back(path.back() + 0.5 * step);
    for (int i = 0; i < 100; ++i) path.push_back(path.back() + step);
    path.push_back(path.back() + 0.5 * step);
  }
  EXPECT_TRUE(path_corners(path).empty());
}

}  // namespace
}  // namespace microslip::path_corners_test
