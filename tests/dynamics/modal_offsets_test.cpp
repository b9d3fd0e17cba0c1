// SPDX-License-Identifier: MIT
// Offsets of a structure that move its modes, with joints, as measured: against its eigenvalues.
#include "microslip/dynamics/structure/modal_offsets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "support/chain_structure.hpp"

namespace microslip::modal_offsets_test {
namespace {

/// Three masses with two joints that are no part of the modes: these hold a fifth to a half of
/// them.
JointedStructure free_of_joints() {
  return testing::chain_structure({3.0, 2.0, 2.5}, {5e5, 4e5, 7e5, 2e5},
                                  {{"lap", 0, 1, Joint(6e5, {})}, {"other", 1, 2, Joint(9e5, {})}},
                                  0.004, {0.0, 0.0});
}

// The eigenvalues of the structure with its joints stuck, before and after, show what arrives of
// the offsets: all of it, to what Newton's method stops at.
TEST(ModalOffsets, ArriveAtTheStructureWithItsJoints) {
  const JointedStructure before = free_of_joints();
  const std::vector<double> wanted{0.004, -0.002, 0.006};
  std::vector<StructureOffset> told;
  for (std::size_t m = 0; m < wanted.size(); ++m) told.push_back({m, wanted[m], {6e5, 9e5}});
  const auto moved_by = [&](const ModalOffsets& found, std::size_t m) {
    const JointedStructure after = with_modal_offsets(before, found.offset);
    return std::log(after.stuck_frequencies()[m] / before.stuck_frequencies()[m]);
  };
  const ModalOffsets all = modal_offsets(before, told, 0.0);
  for (std::size_t m = 0; m < wanted.size(); ++m) {
    EXPECT_NEAR(moved_by(all, m), wanted[m], 1e-9) << m;
    EXPECT_GT(std::abs(all.offset[m]), 1.1 * std::abs(wanted[m])) << m;  // the joints keep theirs
    EXPECT_NEAR(all.left[m], 0.0, 1e-9) << m;
  }
  // A measured mode leaves the others at their prior values, except for their part.
  const ModalOffsets one = modal_offsets(before, {told.data(), 1}, 0.003);
  EXPECT_NEAR(moved_by(one, 0), 0.004, 1e-9);
  EXPECT_NEAR(one.offset[2], 0.003, 5e-4);
  EXPECT_GT(one.left[2], 0.9);
  // Derivative of an offset by the measured one: a finite difference.
  told[1].offset += 1e-5;
  const ModalOffsets more = modal_offsets(before, told, 0.0);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR((more.offset[i] - all.offset[i]) / 1e-5, all.by_told[i][1], 1e-3) << i;
  }
}

}  // namespace
}  // namespace microslip::modal_offsets_test
