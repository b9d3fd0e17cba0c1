// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/joint/memory.hpp"
#include "support/structures.hpp"

namespace microslip::marched_vibration_test {
namespace {

using std::numbers::pi;

/// Two modes and two joints that both move, driven by a force with a strong third harmonic.
JointedStructure two_modes() {
  const ModalModel linear({{1.0, 0.1}, {3.1, 0.1}}, {{"drive", {1.0, 0.6}}, {"end", {0.7, -1.0}}});
  const Joint soft = Joint::four_parameter(0.3, 0.5, -0.4, 0.3);
  const Joint hard(2.0, SlipDensity({UniformPart{0.0, 0.6, 0.7}}));
  return JointedStructure(linear, {{"soft", soft, {1.0, 0.2}}, {"hard", hard, {0.3, -1.0}}},
                          {{"drive", {1.0, 0.0, {0.5, 0.8}}}});
}

struct March {
  std::vector<std::complex<double>> response;  ///< harmonics of the displacement at "end"
  std::array<double, 2> dissipation{};         ///< of each joint over the last cycle
};

/// The vibration in time from rest by the leapfrog scheme with centred damping, of second order,
/// until the transient is gone (e^-0.05·1.1·τ/… over the cycles: below 1e-8).
March march(const JointedStructure& structure, double omega, double force, int steps) {
  constexpr int kCycles = 80;
  const double h = 2.0 * pi / omega / steps;
  const auto joints = structure.joints();
  const auto modes = structure.linear().modes();
  const auto drive = structure.linear().shape("drive");
  const auto end = structure.linear().shape("end");
  Memory soft(joints[0].joint);
  Memory hard(joints[1].joint);
  std::array<Memory*, 2> memory{&soft, &hard};
  std::array<double, 2> q{};
  std::array<double, 2> v{};  // half a step behind
  March result{std::vector<std::complex<double>>(4), {}};
  for (int step = 0; step < kCycles * steps; ++step) {
    const double tau = omega * h * step;
    double f = 0.0;
    for (std::size_t n = 1; n <= 3; ++n) {
      const auto s = structure.excitations()[0].harmonics[n - 1];
      f += force * std::real(s * std::polar(1.0, static_cast<double>(n) * tau));
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const double natural = modes[i].angular_frequency;
      double load = drive[i] * f - natural * natural * q[i];
      for (std::size_t j = 0; j < 2; ++j) load -= joints[j].shape[i] * memory[j]->force();
      const double damping = 0.5 * h * modes[i].loss_factor * natural;
      v[i] = ((1.0 - damping) * v[i] + h * load) / (1.0 + damping);
    }
    const bool last = step >= (kCycles - 1) * steps;
    if (last) {
      const double w = end[0] * q[0] + end[1] * q[1];
      for (std::size_t n = 0; n < 4; ++n) {
        result.response[n] +=
            (n == 0 ? 1.0 : 2.0) / steps * w * std::polar(1.0, -static_cast<double>(n) * tau);
      }
    }
    for (std::size_t i = 0; i < 2; ++i) q[i] += h * v[i];
    for (std::size_t j = 0; j < 2; ++j) {
      const double before = memory[j]->force();
      const double from = memory[j]->displacement();
      const double to = joints[j].shape[0] * q[0] + joints[j].shape[1] * q[1];
      const double after = memory[j]->advance(to);
      if (last) result.dissipation[j] += 0.5 * (before + after) * (to - from);
    }
  }
  return result;
}

// The same equations solved in time. The march errs by (ωh)² = 2e-6 relative and more in harmonic
// 3, the balance by what harmonics above 15 do: 1e-4 of the largest leaves room for a drift by
// both.
TEST(HarmonicBalance, AgreesWithAMarchInTime) {
  const JointedStructure structure = two_modes();
  const HarmonicBalance balance(structure, {"end"}, {.harmonics = 15, .samples = 512});
  std::size_t inner = 0;
  for (const double force : {0.05, 0.4, 1.5}) {
    for (const double omega : {0.7, 1.1, 1.6}) {
      const auto result =
          balance.solve({Quantity::kAngularFrequency, omega}, {Quantity::kForceAmplitude, force});
      ASSERT_TRUE(result.summary.converged()) << result.summary.full();
      EXPECT_LE(result.vibration.energy_imbalance, 1e-8);
      const March marched = march(structure, omega, force, 4000);
      const auto response = result.vibration.displacement(structure.linear(), "end");
      const double size = std::abs(response[1]) + std::abs(response[3]);
      for (std::size_t n = 1; n < 4; ++n) {
        EXPECT_LT(std::abs(response[n] - marched.response[n]), 1e-4 * size)
            << force << " N, " << omega << " rad/s, harmonic " << n;
      }
      for (std::size_t j = 0; j < 2; ++j) {
        const JointCycle& joint = result.vibration.joints[j];
        inner += joint.reversals > 2 ? 1 : 0;
        EXPECT_NEAR(joint.dissipation, marched.dissipation[j], 1e-3 * marched.dissipation[j])
            << force << " N, " << omega << " rad/s, joint " << joint.name;
      }
    }
  }
  EXPECT_GE(inner, 4U);  // of 18: inner loops are what this is about
}

}  // namespace
}  // namespace microslip::marched_vibration_test
