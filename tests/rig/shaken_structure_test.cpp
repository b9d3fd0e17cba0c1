// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/shaken_structure.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "support/densities.hpp"
#include "support/rigs.hpp"

namespace microslip::shaken_structure_test {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

// At 1 mm/s² next to nothing slips: what a small voltage changes is the transfer function of the
// linear structure with the shaker, to the slip and the shortening that are left.
TEST(ShakenStructure, AnswersSmallVoltagesAsTheLinearStructure) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  constexpr double kResponse = 1e-3;
  const Rig rig = testing::reference_rig();
  const StickState state = stick_state(rig, 7);
  const Joint joint = testing::reference_joint();
  const RigInMotion motion(rig, state, joint, {.harmonics = 10, .samples = 256}, 0.0);
  const VibrationResult resonance =
      motion.balance().solve({Quantity::kPhaseLag, kTurn / 4.0}, {Quantity::kResponse, kResponse});
  ASSERT_TRUE(resonance.summary.converged()) << resonance.summary.full();
  ShakenStructure structure(motion, RigShaker{}, resonance.vibration.angular_frequency, kResponse,
                            resonance.vibration);
  const auto force = [&](double voltage) {
    const auto outcome = structure.settle(VectorXcd::Constant(9, voltage));
    EXPECT_TRUE(outcome.summary.converged()) << outcome.summary.full();
    return VectorXcd(outcome.force * outcome.driven.vibration.force_amplitude);
  };
  const VectorXcd at_rest = force(0.0);
  const double probe = 0.005 * structure.settle(VectorXcd::Zero(9)).drive;
  const VectorXcd measured = (force(probe) - at_rest) / probe;
  const VectorXcd linear = structure.linear_transfer();
  ASSERT_EQ(linear.size(), measured.size());
  for (Index i = 0; i < linear.size(); ++i) {
    EXPECT_LT(std::abs(measured[i] - linear[i]), 0.01 * std::abs(linear[i])) << i + 2;
  }
}

}  // namespace
}  // namespace microslip::shaken_structure_test
