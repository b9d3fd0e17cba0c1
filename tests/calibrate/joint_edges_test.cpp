// SPDX-License-Identifier: MIT
#include "microslip/calibrate/joint_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace microslip::joint_edges_test {
namespace {

constexpr double kLength = 1e-4;  // m
constexpr std::size_t kLevels = 20;

/// Levels in equal ratios over two decades.
LinearisedLevels levels_up_to_length() {
  LinearisedLevels levels;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const double down = static_cast<double>(kLevels - 1 - i) / static_cast<double>(kLevels - 1);
    levels.amplitude.push_back({kLength * std::pow(0.01, down)});
  }
  return levels;
}

// Each level shows a loss and a stiffness: two of them are more than the straight line beyond the
// edge of a joint that is driven just past it. A single one is not.
TEST(JointEdges, HaveRoomBelowTheTwoLargestLevels) {
  const ModalLevels none;
  const CalibrationEvidence evidence{.levels = none,
                                     .frequency = FrequencyUse::kChange,
                                     .fit_stiffness = false,
                                     .stuck_shapes = false,
                                     .forcing = {},
                                     .column = {},
                                     .loss_std_given = false,
                                     .frequency_std_given = false};
  const LinearisedLevels levels = levels_up_to_length();
  const AllUnknowns unknowns({0}, {JointUnknowns(6e5, kLength, 0.01, 0.0, 40)});
  JointEdges model(evidence, levels, unknowns, 0, {});
  const auto has_room_below = [&](std::size_t level) {
    const double s =
        std::sqrt(levels.amplitude[level - 1][0] * levels.amplitude[level][0]) / kLength;
    const double place = unknowns.of(0).uniform().place(s);
    const EdgedFit fit{.edges = {{static_cast<int>(std::lround(place)), place}}};
    return !model.search().elsewhere(fit, {0.0}, 1).empty();
  };
  EXPECT_TRUE(has_room_below(kLevels - 3));
  EXPECT_TRUE(has_room_below(kLevels - 2));
  EXPECT_FALSE(has_room_below(kLevels - 1));
}

}  // namespace
}  // namespace microslip::joint_edges_test
