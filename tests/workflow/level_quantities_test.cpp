// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/level_quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "workflow/results.hpp"

namespace microslip::level_quantities_test {
namespace {

using test::kBeta;
using test::results_with_damping;

// D holds βA² of another part; what is left is that of the joint, but for the rounding of a sum.
TEST(LevelQuantities, NetDissipationIsThatOfTheJoint) {
  const ExperimentResults results = results_with_damping();
  const std::vector<double> net = net_dissipation(results);
  const Levels& levels = results.levels->levels;
  for (std::size_t i = 0; i < net.size(); ++i) {
    EXPECT_NEAR(net[i], dissipation(results.joint->joint, levels.amplitude[i]),
                1e-15 * levels.dissipation[i]);
  }
  EXPECT_LT(misfit_of_levels(results).rms, 1e-12);
}

// By hand: 2 % on one level of four, without standard deviations, is an rms of 1 %.
TEST(LevelQuantities, MisfitIsTheRmsOfTheLevelsInUse) {
  ExperimentResults results = results_with_damping();
  results.joint->linear_damping.reset();
  for (std::size_t i = 0; i < results.levels->levels.size(); ++i) {
    results.levels->levels.dissipation[i] =
        dissipation(results.joint->joint, results.levels->levels.amplitude[i]);
  }
  results.levels->levels.dissipation[1] /= 0.98;  // (D − fit)/D = 0.02
  const Misfit misfit = misfit_of_levels(results);
  EXPECT_NEAR(misfit.rms, 0.01, 1e-13);
  EXPECT_FALSE(misfit.in_deviations);
  EXPECT_NEAR(relative_residuals(results).value[1], 0.02, 1e-13);
  results.levels->left_out = {false, true, false, false};
  EXPECT_LT(misfit_of_levels(results).rms, 1e-12);
}

// σ of a difference of D and a curve D(A) + βA² at an A that is uncertain by ± σ_A.
TEST(LevelQuantities, DeviationsHoldThoseOfTheAmplitude) {
  ExperimentResults results = results_with_damping();
  Levels& levels = results.levels->levels;
  levels.dissipation_std = {3e-6, 3e-6, 3e-6, 3e-6};
  levels.amplitude_std = {0.0, 0.0, 0.0, 1e-7};
  const std::vector<double> deviations = dissipation_deviations(results);
  EXPECT_EQ(deviations[0], 3e-6);
  const auto total = [&](double a) { return dissipation(results.joint->joint, a) + kBeta * a * a; };
  const double change =
      0.5 * (total(levels.amplitude[3] + 1e-7) - total(levels.amplitude[3] - 1e-7));
  EXPECT_NEAR(deviations[3], std::hypot(3e-6, change), 1e-15);
}

TEST(LevelQuantities, LossFactorIsThatOfTheJoint) {
  const ExperimentResults results = results_with_damping();
  const MeasuredPoints measured = measured_loss_factor(results);
  for (std::size_t i = 0; i < measured.value.size(); ++i) {
    const double expected = loss_factor(results.joint->joint, results.levels->levels.amplitude[i]);
    EXPECT_NEAR(measured.value[i], expected, 1e-12 * expected);
  }
}

// E = cA² is what the interpolation keeps exactly: ζ = W/(4πcA²).
TEST(LevelQuantities, DampingByTheEnergyOfTheBackbone) {
  constexpr double kEnergy = 2.5e4;  // J/m²
  ExperimentResults results = results_with_damping();
  EXPECT_EQ(linear_share(*results.levels), std::vector<double>(4, 0.25));
  results.backbone = JointBackbone{{1e-5, 2e-5, 1e-3}, {55.0, 54.0, 53.0}, {0.01, 0.01, 0.01}};
  EXPECT_TRUE(measured_damping(results).empty());
  for (const double a : results.backbone->amplitude) {
    results.backbone->vibration_energy.push_back(kEnergy * a * a);
  }
  const std::vector<double> ratio = measured_damping(results);
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    const double a = results.levels->levels.amplitude[i];
    const double expected =
        results.levels->input_energy[i] / (4.0 * std::numbers::pi * kEnergy * a * a);
    EXPECT_NEAR(ratio[i], expected, 1e-12 * expected);
  }
}

}  // namespace
}  // namespace microslip::level_quantities_test
