// SPDX-License-Identifier: MIT
// Offsets of a structure that move its modes, with joints, as measured: against its eigenvalues.
#include "microslip/dynamics/structure/modal_offsets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
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
  std::vector<StructureOffset> measured;
  for (std::size_t m = 0; m < wanted.size(); ++m) measured.push_back({m, wanted[m], {6e5, 9e5}});
  const auto moved_by = [&](const ModalOffsets& found, std::size_t m) {
    const JointedStructure after = with_modal_offsets(before, found.offset);
    return std::log(after.stuck_frequencies()[m] / before.stuck_frequencies()[m]);
  };
  const ModalOffsets all = modal_offsets(before, measured, 0.0);
  for (std::size_t m = 0; m < wanted.size(); ++m) {
    EXPECT_NEAR(moved_by(all, m), wanted[m], 1e-9) << m;
    EXPECT_GT(std::abs(all.offset[m]), 1.1 * std::abs(wanted[m])) << m;  // the joints keep theirs
    EXPECT_NEAR(all.left[m], 0.0, 1e-9) << m;
  }
  // A measured mode leaves the others at their prior values, except for their part.
  const ModalOffsets one = modal_offsets(before, {measured.data(), 1}, 0.003);
  EXPECT_NEAR(moved_by(one, 0), 0.004, 1e-9);
  EXPECT_NEAR(one.offset[2], 0.003, 5e-4);
  EXPECT_GT(one.left[2], 0.9);
  // Derivative of an offset by the measured one: a finite difference.
  measured[1].offset += 1e-5;
  const ModalOffsets more = modal_offsets(before, measured, 0.0);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR((more.offset[i] - all.offset[i]) / 1e-5, all.by_measured[i][1], 1e-3) << i;
  }
}

// Springs across the joints in the modes that are off as these are scale the stiffness of all that
// is not a joint: with joints that are scaled, too, each frequency is off by just that.
TEST(ModalOffsets, ScaleAStructureWithItsSprings) {
  constexpr double kOff = 0.01;
  const std::vector<double> modes(3, kOff);
  const std::vector<double> springs(2, kOff);
  const JointedStructure before = testing::chain_structure(
      {3.0, 2.0, 2.5}, {5e5, 4e5, 7e5, 2e5},
      {{"lap", 0, 1, Joint(6e5, {})}, {"other", 1, 2, Joint(9e5, {})}}, 0.004, {6e5, 9e5});
  std::vector<StructuralJoint> stiffer(before.joints().begin(), before.joints().end());
  for (StructuralJoint& joint : stiffer) {
    joint.joint = Joint(std::exp(2.0 * kOff) * joint.joint.stiffness(), {});
  }
  const JointedStructure after = with_modal_offsets(before.with_joints(stiffer), modes, springs);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    EXPECT_NEAR(std::log(after.stuck_frequencies()[m] / before.stuck_frequencies()[m]), kOff, 1e-12)
        << m;
  }
  // What each share of a vibration counts: a finite difference, with joints as they are.
  const StructureOffset stuck{.mode = 1, .joint_stiffness = {6e5, 9e5}};
  const VibrationShares shares = vibration_shares(before, stuck);
  constexpr double kStep = 1e-5;
  const auto slope = [&](std::span<const double> some, std::span<const double> moved) {
    return std::log(secant_frequency(with_modal_offsets(before, some, moved), stuck) /
                    secant_frequency(before, stuck)) /
           kStep;
  };
  const std::vector<double> none(3, 0.0);
  EXPECT_NEAR(slope(std::vector<double>{kStep, 0.0, 0.0}, {}), shares.modes[0], 1e-4);
  EXPECT_NEAR(slope(none, std::vector<double>{0.0, kStep}), -shares.springs[1], 1e-4);
  EXPECT_NEAR(slope(std::vector<double>(3, kStep), std::vector<double>(2, kStep)),
              shares.without_joints(), 1e-4);
}

}  // namespace
}  // namespace microslip::modal_offsets_test
