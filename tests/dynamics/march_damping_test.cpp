// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/dynamics/march/march.hpp"
#include "support/messages.hpp"
#include "support/structures.hpp"

namespace microslip::march_damping_test {
namespace {

using std::numbers::pi;

constexpr double kBeta = 0.05;  // J/m²

/// 1 kg on 0.75 N/m, and a joint of 0.25 N/m that loses by β: 1 rad/s. A rigid mode in which it
/// does not move, and one at 0.5 rad/s, are not what the damper is made for.
JointedStructure damped_mass(Joint joint, double spring_in_modes) {
  const double omega = std::sqrt(0.75 + spring_in_modes);
  return JointedStructure(
      ModalModel({{0.0, 0.0}, {0.5, 0.0}, {omega, 0.0}}, {{"mass", {0.0, 0.0, 1.0}}}),
      {{.name = "joint",
        .joint = std::move(joint),
        .shape = {0.0, 0.0, 1.0},
        .spring_in_modes = spring_in_modes,
        .linear_damping = kBeta}},
      {{"mass"}});
}

std::vector<double> times(std::size_t count, double step) {
  std::vector<double> time(count);
  for (std::size_t i = 0; i < count; ++i) time[i] = step * static_cast<double>(i);
  return time;
}

// A joint that does not slip is a spring: free decay with c = β/(πω), ω = 1, in closed form. The
// estimate must be that of the error.
TEST(MarchDamping, DecaysAsTheClosedForm) {
  const double damper = kBeta / pi;
  const double zeta = 0.5 * damper;
  const double omega = std::sqrt(1.0 - zeta * zeta);
  for (const double spring : {0.0, 0.2}) {
    const JointedStructure structure = damped_mass(Joint(0.25, SlipDensity()), spring);
    const MarchResult found =
        march(structure, {times(201, 0.5), {}},
              {.step = 0.125, .points = {"mass"}, .start = {.displacement = {0.0, 0.0, 1.0}}});
    ASSERT_TRUE(found.summary.converged()) << found.summary.full();
    double error = 0.0;
    for (std::size_t i = 0; i < found.time.size(); ++i) {
      const double t = found.time[i];
      const double exact =
          std::exp(-zeta * t) * (std::cos(omega * t) + zeta / omega * std::sin(omega * t));
      error = std::max(error, std::abs(found.points[0].displacement[i] - exact));
    }
    EXPECT_LT(error, 2e-5);
    EXPECT_GT(*found.error_estimate, 0.2 * error);
    EXPECT_LT(*found.error_estimate, 5.0 * error);
    EXPECT_LT(found.energy.imbalance(), 1e-5);
    EXPECT_EQ(found.energy.joints[0].dissipation, 0.0);
    EXPECT_NEAR(found.energy.joint_linear_dissipation(), 0.5 * (1.0 - std::exp(-200.0 * zeta)),
                2e-3);  // the energy swings by ζ within a cycle
  }
}

// In the steady state at 1 rad/s a cycle of amplitude A loses βA², whatever its phase.
TEST(MarchDamping, LosesBetaASquareInACycle) {
  const JointedStructure structure = damped_mass(Joint(0.25, SlipDensity()), 0.0);
  constexpr std::size_t kSamples = 64;
  constexpr std::size_t kCycles = 300;  // the transient falls by e^−15
  LoadHistory loads{times(kSamples * kCycles + 1, 2.0 * pi / kSamples), {{"mass", {}}}};
  for (const double t : loads.time) loads.forces[0].force.push_back(0.01 * std::sin(t));
  const auto lost = [&](std::size_t cycles) {
    LoadHistory part = loads;
    part.time.resize(cycles * kSamples + 1);
    part.forces[0].force.resize(part.time.size());
    const MarchResult found = march(structure, part, {.points = {"mass"}});
    EXPECT_TRUE(found.summary.converged()) << found.summary.full();
    double amplitude = 0.0;
    for (std::size_t i = part.time.size() - kSamples; i < part.time.size(); ++i) {
      amplitude = std::max(amplitude, std::abs(found.points[0].displacement[i]));
    }
    return std::pair{found.energy.joints[0].linear_dissipation, amplitude};
  };
  const auto [all, amplitude] = lost(kCycles);
  // 64 straight pieces a cycle are 8e-4 less than the sine.
  EXPECT_NEAR(all - lost(kCycles - 1).first, kBeta * amplitude * amplitude,
              1e-3 * kBeta * amplitude * amplitude);
}

// With slip, shortening and a compliance in series: the balance holds, and the loss is reported.
TEST(MarchDamping, KeepsTheEnergyBesideSlip) {
  const JointedStructure structure(
      ModalModel({{std::sqrt(0.75), 0.01}, {3.0, 0.01}}, {{"mass", {1.0, 0.5}}}),
      {{.name = "joint",
        .joint = Joint::four_parameter(0.2, 0.25, -0.5, 0.3),
        .shape = {1.0, -0.4},
        .series_compliance = 1e-3,
        .shortening = {0.01, 0.02, 0.02, 0.03},
        .linear_damping = kBeta}},
      {{"mass"}});
  LoadHistory loads{times(401, 0.25), {{"mass", {}}}};
  for (const double t : loads.time) loads.forces[0].force.push_back(0.1 * std::sin(0.95 * t));
  const MarchResult found = march(structure, loads, {.points = {"mass"}});
  ASSERT_TRUE(found.summary.converged()) << found.summary.full();
  EXPECT_LT(found.energy.imbalance(), 2e-5);
  EXPECT_GT(found.energy.joint_dissipation(), 0.1 * found.energy.input);
  EXPECT_GT(found.energy.joint_linear_dissipation(), 0.01 * found.energy.input);
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_EQ(found.warnings[0].code, "damping_as_viscous");
  test::expect_message(found.warnings[0].text,
                       "linear damping of 'joint', 0.05 J/m^2, has no time-domain form");
}

}  // namespace
}  // namespace microslip::march_damping_test
