// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/structure/damping_twice.hpp"
#include "microslip/joint/dissipation.hpp"
#include "support/figures.hpp"
#include "support/structures.hpp"

namespace microslip::linear_damping_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A mass of 1 kg that joint and linear damping alone hold, driven by several harmonics.
JointedStructure held_mass(Joint joint, double linear_damping,
                           std::vector<std::complex<double>> force = {1.0}) {
  const double k = joint.stiffness();
  ModalModel linear({{std::sqrt(k), 0.0}}, {{"mass", {1.0}}});
  StructuralJoint held{.name = "joint",
                       .joint = std::move(joint),
                       .shape = {1.0},
                       .spring_in_modes = k,
                       .linear_damping = linear_damping};
  return JointedStructure(std::move(linear), {std::move(held)}, {{"mass", std::move(force)}});
}

// A spring of k(1 + iβ/(πk)): w_n = F_n/(k − n²ω² + iβ/π) whatever the frequency; the loss of each
// harmonic is nβ|w_n|².
TEST(LinearDamping, IsALossFactorOfTheStuckJoint) {
  constexpr double kStiffness = 4.0;
  const std::complex<double> third{0.2, -0.4};
  for (const double beta : {0.01, 1.0, 30.0}) {
    const HarmonicBalance balance(
        held_mass(Joint(kStiffness, SlipDensity()), beta, {1.0, 0.0, third}), {"mass"});
    for (const double omega : {0.3, 0.667, 1.9, 2.0, 7.0}) {
      const VibrationResult found =
          balance.solve({Quantity::kAngularFrequency, omega}, {Quantity::kForceAmplitude, 3.0});
      ASSERT_TRUE(found.summary.converged()) << found.summary.full();
      const JointCycle& joint = found.vibration.joints.front();
      double lost = 0.0;
      for (const auto& [n, force] : {std::pair{1, std::complex<double>(3.0)}, {3, 3.0 * third}}) {
        const std::complex<double> expected =
            force / std::complex<double>(kStiffness - n * n * omega * omega, beta / pi);
        const double error = std::abs(joint.displacement[static_cast<std::size_t>(n)] - expected) /
                             std::abs(expected);
        EXPECT_LE(error, 1e-9) << beta << ", " << omega << ", " << n;
        test::record_largest("displacement [1]", error);
        lost += n * beta * std::norm(expected);
      }
      EXPECT_NEAR(joint.linear_dissipation, lost, 1e-9 * lost);
      EXPECT_NEAR(joint.dissipation, lost, 1e-9 * lost);
      EXPECT_LE(found.vibration.energy_imbalance, 1e-9);
    }
  }
}

// In one harmonic all is closed: D = slip + βA², ζ = D/(2πω²A²). 4096 samples leave some 1e-7 of
// slip.
TEST(LinearDamping, AddsToSlipByTheSquareOfTheAmplitude) {
  constexpr double kBeta = 0.05;
  for (const Joint& joint : testing::joints_of_each_kind()) {
    const HarmonicBalance balance(held_mass(joint, kBeta), {"mass"},
                                  {.harmonics = 1, .samples = 4096});
    const double stuck = std::sqrt(joint.stiffness());
    for (const double a : {0.01, 0.1, 0.3}) {
      const VibrationResult found =
          balance.solve({Quantity::kAngularFrequency, 0.9 * stuck}, {Quantity::kResponse, a});
      ASSERT_TRUE(found.summary.converged()) << found.summary.full();
      const JointCycle& cycle = found.vibration.joints.front();
      const double expected = dissipation(joint, a) + kBeta * a * a;
      EXPECT_NEAR(cycle.linear_dissipation, kBeta * a * a, 1e-10 * kBeta * a * a);
      EXPECT_NEAR(cycle.dissipation, expected, 1e-6 * expected) << a;
      EXPECT_NEAR(found.vibration.damping_ratio(),
                  expected / (2.0 * pi * std::pow(0.9 * stuck * a, 2)), 1e-6);
    }
  }
}

// With slip, harmonics and series compliance: slip is what is left of D, and energy is conserved.
TEST(LinearDamping, IsSeparateFromSlipInTheEnergies) {
  const JointedStructure plain = testing::friction_rig(3);
  std::vector<StructuralJoint> joints(plain.joints().begin(), plain.joints().end());
  constexpr double kBeta = 6000.0;
  joints.front().linear_damping = kBeta;
  const std::vector<Excitation> excitations(plain.excitations().begin(), plain.excitations().end());
  const JointedStructure damped(plain.linear(), joints, excitations, plain.damping());
  const auto solve = [](const JointedStructure& structure) {
    return HarmonicBalance(structure, {"force", ResponseKind::kAcceleration}, {.harmonics = 5})
        .solve(kPhaseResonance, {Quantity::kResponse, 20.0});
  };
  const VibrationResult with = solve(damped);
  const VibrationResult without = solve(plain);
  ASSERT_TRUE(with.summary.converged()) << with.summary.full();
  ASSERT_TRUE(without.summary.converged()) << without.summary.full();
  const JointCycle& cycle = with.vibration.joints.front();
  const JointCycle& bare = without.vibration.joints.front();
  double lost = 0.0;
  for (std::size_t n = 1; n < cycle.displacement.size(); ++n) {
    lost += static_cast<double>(n) * kBeta * std::norm(cycle.displacement[n]);
  }
  EXPECT_NEAR(cycle.linear_dissipation, lost, 1e-12 * lost);
  EXPECT_GT(lost, 0.1 * cycle.dissipation) << "else the test is of nothing";
  EXPECT_LE(with.vibration.energy_imbalance, 1e-8);
  EXPECT_EQ(bare.linear_dissipation, 0.0);
  // At the same response the joint moves the same but for the higher harmonics: slip is the same.
  const double slip = cycle.dissipation - cycle.linear_dissipation;
  EXPECT_NEAR(slip, bare.dissipation, 2e-3 * bare.dissipation);
  EXPECT_GT(with.vibration.force_amplitude, 1.05 * without.vibration.force_amplitude);
}

TEST(DampingTwice, IsSeenWhereModeAndJointLoseTheSame) {
  const Joint joint(508000.0, SlipDensity());
  const auto warned = [&](double beta, double loss_factor, double spring) {
    const double shape = 0.7085;
    const ModalModel linear({{2.0 * pi * 80.38, loss_factor}, {2.0 * pi * 300.0, loss_factor}},
                            {{"drive", {shape, 0.5}}});
    const StructuralJoint held{.name = "joint",
                               .joint = joint,
                               .shape = {shape, 0.0},
                               .spring_in_modes = spring,
                               .linear_damping = beta};
    const JointedStructure structure(linear, {held}, {{"drive"}});
    return damping_twice(structure);
  };
  const std::vector<Warning> found = warned(4672.0, 0.00293, 508000.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "damping_twice");
  EXPECT_EQ(found[0].text.substr(0, 88),
            "mode 1 has a loss factor of 0.00293, and joint 'joint', which is its stiffness, gives "
            "it");
  EXPECT_EQ(warned(4672.0, 0.0055, 508000.0).size(), 1U);
  EXPECT_TRUE(warned(4672.0, 0.0065, 508000.0).empty()) << "another loss";
  EXPECT_TRUE(warned(4672.0, 0.0001, 508000.0).empty()) << "another loss";
  EXPECT_TRUE(warned(4672.0, 0.0, 508000.0).empty());
  EXPECT_TRUE(warned(0.0, 0.00293, 508000.0).empty());
  EXPECT_TRUE(warned(4672.0, 0.00293, 400000.0).empty()) << "a fifth of the mode is not the joint";
}

}  // namespace
}  // namespace microslip::linear_damping_test
