// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/density_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/dynamics/march/march.hpp"
#include "support/structures.hpp"

namespace microslip::density_corners_test {
namespace {

/// Atoms of 0.3 together, and uniform parts of 0.6, which jump at two places each.
SlipDensity density_of(std::size_t atoms, std::size_t uniform) {
  std::vector<DensityPart> parts;
  AtomsPart part;
  for (std::size_t a = 0; a < atoms; ++a) {
    part.slip_force.push_back(0.05 + 0.01 * static_cast<double>(a));
    part.weight.push_back(0.3 / static_cast<double>(atoms));
  }
  if (atoms > 0) parts.emplace_back(part);
  for (std::size_t u = 0; u < uniform; ++u) {
    const double from = 0.01 + 0.02 * static_cast<double>(u);
    parts.emplace_back(UniformPart{from, from + 0.01, 0.6 / static_cast<double>(uniform)});
  }
  return SlipDensity(std::move(parts));
}

struct Count {
  std::size_t atoms;
  std::size_t jumps;
  bool operator==(const Count&) const = default;
};

Count corners(std::size_t atoms, std::size_t uniform) {
  Count count{0, 0};
  for (const Corner& corner : corners_of(density_of(atoms, uniform))) {
    ++(corner.atom ? count.atoms : count.jumps);
  }
  return count;
}

TEST(DensityCorners, AreAtomsUpToSixteenAndJumpsBesideThem) {
  EXPECT_EQ(corners(3, 4), (Count{3, 8}));
  EXPECT_EQ(corners(16, 0), (Count{16, 0}));
  EXPECT_EQ(corners(0, 8), (Count{0, 16}));
  EXPECT_EQ(corners(1, 8), (Count{1, 0}));
  EXPECT_EQ(corners(0, 9), (Count{0, 0}));
  EXPECT_EQ(corners(17, 1), (Count{0, 0}));
  const auto rising = corners_of(density_of(3, 4));
  EXPECT_TRUE(std::ranges::is_sorted(rising, {}, &Corner::slip_force));
}

// 1/128 of all atoms, with a few that are as heavy as all the light ones.
TEST(DensityCorners, AreHeavyAtomsOfCurves) {
  EXPECT_EQ(heavy_atoms(density_of(3, 4)).size(), 3U);
  EXPECT_EQ(heavy_atoms(density_of(127, 0)).size(), 127U);
  EXPECT_EQ(heavy_atoms(density_of(129, 0)).size(), 0U);
  AtomsPart part{{0.5, 0.7}, {0.1, 0.2}};
  for (int i = 0; i < 1000; ++i) {
    part.slip_force.push_back(1.0 + 1e-3 * i);
    part.weight.push_back(3e-4);
  }
  EXPECT_EQ(heavy_atoms(SlipDensity({part})), (std::vector<double>{0.5, 0.7}));
}

TEST(DensityCorners, CountAtomsForTheOrder) {
  const auto many = [](std::size_t atoms, std::size_t uniform) {
    return has_many_atoms(testing::one_mass(Joint(0.25, density_of(atoms, uniform))));
  };
  EXPECT_FALSE(many(1, 9));
  EXPECT_FALSE(many(16, 9));
  EXPECT_TRUE(many(17, 0));
}

// An atom is met in a march however many jumps there are: half the step, less than a seventh of the
// error, which is a quarter where the atom is passed over.
TEST(DensityCorners, KeepTheOrderOfAMarchWithManyJumps) {
  const JointedStructure structure = testing::one_mass(Joint(0.25, density_of(1, 9)));
  LoadHistory loads{{}, {{"mass", {}}}};
  for (int i = 0; i <= 200; ++i) {
    loads.time.push_back(0.4 * i);
    loads.forces[0].force.push_back(0.05 * std::sin(0.95 * loads.time.back()));
  }
  const auto motion = [&](double step) {
    const MarchResult result =
        march(structure, loads, {.step = step, .points = {"mass"}, .tolerance = 1e-12});
    EXPECT_GT(result.kinks, 10U);
    return result.points[0].displacement;
  };
  const std::vector<double> exact = motion(0.4 / 256);
  const auto error = [&](double step) {
    const std::vector<double> found = motion(step);
    double most = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k) {
      most = std::max(most, std::abs(found[k] - exact[k]));
    }
    return most;
  };
  EXPECT_LT(error(0.05), error(0.2) / 36.0);  // two halvings at order 2.6; at order 2 it is 16
}

}  // namespace
}  // namespace microslip::density_corners_test
