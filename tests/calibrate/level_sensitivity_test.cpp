// SPDX-License-Identifier: MIT
#include "microslip/calibrate/level_sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/chain_structure.hpp"

namespace microslip::level_sensitivity_test {
namespace {

JointedStructure structure_with(double first, double second, double compliance) {
  const std::vector<testing::ChainJoint> joints{
      {"a", 1, 2, Joint(8e5, SlipDensity({UniformPart{0.0, 120.0, first}}))},
      {"b", -1, 3, Joint(5e5, SlipDensity({UniformPart{0.0, 150.0, second}}))}};
  const JointedStructure chain = testing::chain_structure(
      {4.0, 3.0, 3.0, 2.5}, {8e5, 6e5, 3e5, 5e5, 0.0}, joints, 0.003, {8e5, 5e5});
  std::vector<StructuralJoint> placed(chain.joints().begin(), chain.joints().end());
  for (StructuralJoint& joint : placed) joint.series_compliance = compliance;
  return {chain.linear(), placed, {Excitation{"p1"}}, chain.damping()};
}

/// The joint scaled by a share, and the change of κ at an amplitude.
std::complex<double> kappa(const Joint& joint, double a) {
  return {secant_stiffness(joint, a), dissipation(joint, a) / (std::numbers::pi * a * a)};
}

class Sensitivity : public ::testing::TestWithParam<std::tuple<Forcing, double, std::size_t>> {};

// Against differences of harmonic balances with five harmonics. The derivatives assume that higher
// harmonics follow, which leaves 1 % and, of small changes, a hundredth of the larger change.
TEST_P(Sensitivity, IsThatOfTheHarmonicBalance) {
  const auto [forcing, compliance, mode] = GetParam();
  constexpr double kStep = 1e-4;
  constexpr double kResponse = 2e-5;
  const auto solve = [&](double first, double second) {
    const HarmonicBalance balance(structure_with(first, second, compliance), {"p1"},
                                  {.forcing = forcing});
    const VibrationResult found =
        balance.solve(kPhaseResonance, {Quantity::kResponse, kResponse}, mode);
    EXPECT_TRUE(found.summary.converged()) << found.summary.reason;
    return found.vibration;
  };
  const SteadyVibration at = solve(0.5, 0.4);
  const LevelSensitivity found =
      level_sensitivity(structure_with(0.5, 0.4, compliance), "p1", at, forcing);
  for (Eigen::Index l = 0; l < 2; ++l) {
    const double first = l == 0 ? kStep : 0.0;
    const double second = l == 1 ? kStep : 0.0;
    const SteadyVibration more = solve(0.5 + first, 0.4 + second);
    const SteadyVibration less = solve(0.5 - first, 0.4 - second);
    const auto joint = static_cast<std::size_t>(l);
    const double a = at.joints[joint].amplitude;
    const auto joint_of = [&](double sign) {
      return structure_with(0.5 + sign * first, 0.4 + sign * second, compliance)
          .joints()[joint]
          .joint;
    };
    const std::complex<double> change = kappa(joint_of(1.0), a) - kappa(joint_of(-1.0), a);
    const double frequency = more.angular_frequency - less.angular_frequency;
    EXPECT_NEAR((found.frequency(l) * change).real(), frequency, 0.01 * std::abs(frequency));
    const double largest = std::abs(more.joints[joint].amplitude - less.joints[joint].amplitude);
    for (Eigen::Index j = 0; j < 2; ++j) {
      const auto row = static_cast<std::size_t>(j);
      const double moved = more.joints[row].amplitude - less.joints[row].amplitude;
      EXPECT_NEAR((found.amplitude(j, l) * change).real(), moved, 0.02 * largest) << j << l;
    }
  }
}

// The derivatives by the displacement of the response point.
TEST_P(Sensitivity, IsThatOfTheDisplacementToo) {
  const auto [forcing, compliance, mode] = GetParam();
  constexpr double kResponse = 2e-5;
  const JointedStructure structure = structure_with(0.5, 0.4, compliance);
  const HarmonicBalance balance(structure, {"p1"}, {.forcing = forcing});
  const auto solve = [&, at_mode = mode](double response) {
    const VibrationResult found =
        balance.solve(kPhaseResonance, {Quantity::kResponse, response}, at_mode);
    EXPECT_TRUE(found.summary.converged()) << found.summary.reason;
    return found.vibration;
  };
  constexpr double kStep = 1e-3 * kResponse;
  const LevelSensitivity found = level_sensitivity(structure, "p1", solve(kResponse), forcing);
  const SteadyVibration more = solve(kResponse + kStep);
  const SteadyVibration less = solve(kResponse - kStep);
  const double frequency = (more.angular_frequency - less.angular_frequency) / (2.0 * kStep);
  EXPECT_NEAR(found.frequency_by_response, frequency, 0.01 * std::abs(frequency));
  for (std::size_t j = 0; j < 2; ++j) {
    const double moved = (more.joints[j].amplitude - less.joints[j].amplitude) / (2.0 * kStep);
    EXPECT_NEAR(found.amplitude_by_response(static_cast<Eigen::Index>(j)), moved, 0.01 * moved);
  }
}

// The derivatives by the frequencies of the modes without joints and by the springs in them: finite
// differences.
TEST_P(Sensitivity, IsThatOfTheModesToo) {
  const auto [forcing, compliance, mode] = GetParam();
  constexpr Target kAt{Quantity::kResponse, 2e-5};
  constexpr double kStep = 1e-4;
  const JointedStructure structure = structure_with(0.5, 0.4, compliance);
  const std::size_t modes = structure.linear().size();
  const auto solve = [&, at_mode = mode, used = forcing](std::size_t moved, double offset) {
    std::vector<double> offsets(modes, 0.0);
    std::vector<double> springs(2, 0.0);
    (moved < modes ? offsets[moved] : springs[moved - modes]) = offset;
    const HarmonicBalance balance(with_modal_offsets(structure, offsets, springs), {"p1"},
                                  {.forcing = used});
    const VibrationResult found = balance.solve(kPhaseResonance, kAt, at_mode);
    EXPECT_TRUE(found.summary.converged()) << found.summary.reason;
    return found.vibration;
  };
  const SteadyVibration at = solve(0, 0.0);
  const LevelSensitivity found = level_sensitivity(structure, "p1", at, forcing);
  for (std::size_t moved = 0; moved < modes + 2; ++moved) {
    const SteadyVibration more = solve(moved, kStep);
    const SteadyVibration less = solve(moved, -kStep);
    const auto column = static_cast<Eigen::Index>(moved);
    const double frequency = (more.angular_frequency - less.angular_frequency) / (2.0 * kStep);
    EXPECT_NEAR(found.frequency_by_mode(column), frequency, 0.003 * at.angular_frequency) << moved;
    for (std::size_t j = 0; j < 2; ++j) {
      const double amplitude = at.joints[j].amplitude;
      const double change =
          (more.joints[j].amplitude - less.joints[j].amplitude) / (2.0 * kStep * amplitude);
      const auto row = static_cast<Eigen::Index>(j);
      EXPECT_NEAR(found.amplitude_by_mode(row, column) / amplitude, change,
                  0.01 * (1.0 + std::abs(change)))
          << moved << j;
    }
  }
}

// Rayleigh's quotient of a mode that no joint changes: δω = ψ_l² Re δκ_l/(2ω). The forcing
// that maintains such a mode cancels all of its own dynamic stiffness, to rounding or, at some
// displacements, exactly.
TEST(StuckSensitivity, IsThatOfRayleigh) {
  const JointedStructure slipping = structure_with(0.5, 0.4, 0.0);
  std::vector<StructuralJoint> joints(slipping.joints().begin(), slipping.joints().end());
  for (StructuralJoint& joint : joints) joint.joint = Joint(joint.joint.stiffness(), SlipDensity());
  const JointedStructure stuck(slipping.linear(), joints, {Excitation{"p1"}}, slipping.damping());
  const HarmonicBalance balance(stuck, {"p1"}, {.forcing = Forcing::kModal});
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const double omega = stuck.linear().modes()[mode].angular_frequency;
    for (int i = 1; i <= 40; ++i) {
      const VibrationResult found =
          balance.solve(kPhaseResonance, {Quantity::kResponse, 1e-6 * std::pow(1.1, i)}, mode);
      ASSERT_TRUE(found.summary.converged()) << found.summary.reason;
      const LevelSensitivity changes =
          level_sensitivity(stuck, "p1", found.vibration, Forcing::kModal);
      for (Eigen::Index l = 0; l < 2; ++l) {
        const double shape = joints[static_cast<std::size_t>(l)].shape[mode];
        EXPECT_NEAR(changes.frequency(l).real() / (0.5 * shape * shape / omega), 1.0, 1e-6)
            << mode << " " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, Sensitivity,
    ::testing::Combine(::testing::Values(Forcing::kExcitation, Forcing::kModal),
                       ::testing::Values(0.0, 2e-7),
                       ::testing::Values(std::size_t{0}, std::size_t{1}, std::size_t{2})));

}  // namespace
}  // namespace microslip::level_sensitivity_test
