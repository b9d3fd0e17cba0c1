// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/stepped_sine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "microslip/base/error.hpp"

namespace microslip::stepped_sine_test {
namespace {

using Complex = std::complex<double>;

// One mode with a joint across which it moves by twice the coordinate; at the level of the sweep
// the joint acts as the complex stiffness kJoint.
constexpr double kFrequency = 80.0;      // Hz, stuck
constexpr double kShape = 0.7;           // kg^-1/2
constexpr double kJointShape = 1.4;      // kg^-1/2
constexpr double kLossFactor = 0.002;    // of the structure
constexpr double kStuck = 5e4;           // k, N/m
constexpr Complex kJoint{4.8e4, 1.2e3};  // N/m
constexpr double kForce = 0.8;           // N

Rig one_mode_rig() {
  Rig rig;
  rig.structure = RigModes{{kFrequency}, {kShape}, {kJointShape}};
  rig.contact.stiffness = kStuck;
  rig.loss_factor = {kLossFactor};
  rig.excitation.channel = "force";
  rig.accelerometers = {{0.0, {kShape}, "acceleration"}};
  return rig;
}

SteppedSine sweep_of(int steps, double sign) {
  SteppedSine sweep{
      .source = "sweep", .frequency = {}, .force = {}, .acceleration = {}, .phase = {}};
  const double square = std::pow(2.0 * std::numbers::pi * kFrequency, 2);
  for (int i = 0; i < steps; ++i) {
    const double frequency = 77.0 + 4.0 * i / (steps - 1);
    const double omega = 2.0 * std::numbers::pi * frequency;
    const Complex stiffness = Complex(square - omega * omega, kLossFactor * square) +
                              kJointShape * kJointShape * (kJoint - kStuck);
    const Complex acceleration = -omega * omega * kShape * kShape * kForce / stiffness;
    sweep.frequency.push_back(frequency);
    sweep.force.push_back(kForce);
    sweep.acceleration.push_back(std::abs(acceleration));
    sweep.phase.push_back(sign * std::arg(acceleration));
  }
  return sweep;
}

TEST(SteppedSine, ResonanceOfOneMode) {
  const Reducer reducer(one_mode_rig());
  for (const double sign : {1.0, -1.0}) {  // either convention of the phase
    const ReducedLevel level = reduce_stepped_sine(reducer, sweep_of(42, sign));
    const double square = std::pow(2.0 * std::numbers::pi * kFrequency, 2);
    const double resonance =
        std::sqrt(square + kJointShape * kJointShape * (kJoint.real() - kStuck));
    // Between steps of 0.1 Hz, the half-power width being 0.5 Hz, the rule is exact for one mode:
    // what it gives belongs together, at a force a little below the one that was held.
    EXPECT_NEAR(level.frequency, resonance / (2.0 * std::numbers::pi), 1e-9);
    const double q = kShape * level.force_amplitude /
                     (kLossFactor * square + kJointShape * kJointShape * kJoint.imag());
    EXPECT_NEAR(level.amplitude.value / (kJointShape * q), 1.0, 1e-9);
    const double loss = std::numbers::pi * kJoint.imag() * std::pow(kJointShape * q, 2);
    EXPECT_NEAR(level.dissipation.value / loss, 1.0, 1e-9);
    EXPECT_NEAR(level.linear_dissipation / (std::numbers::pi * kLossFactor * square * q * q), 1.0,
                1e-9);
    EXPECT_NEAR(level.secant_stiffness->value / kJoint.real(), 1.0, 1e-9);
    const double lossy = kLossFactor * square + kJointShape * kJointShape * kJoint.imag();
    EXPECT_NEAR(level.damping_ratio / (0.5 * lossy / resonance / resonance), 1.0, 1e-9);
    EXPECT_TRUE(level.flags.empty());
  }
}

std::string message_of(const SteppedSine& sweep) {
  try {
    (void)reduce_stepped_sine(Reducer(one_mode_rig()), sweep);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SteppedSine, SaysWhatIsWrong) {
  SteppedSine sweep = sweep_of(21, 1.0);
  sweep.phase.assign(21, 0.3);
  EXPECT_NE(message_of(sweep).find("must pass a quarter turn"), std::string::npos);
  sweep = sweep_of(21, 1.0);
  sweep.force[3] = -1.0;
  EXPECT_NE(message_of(sweep).find("sweep: force of step 4 = -1"), std::string::npos);
  sweep = sweep_of(21, 1.0);
  sweep.phase.pop_back();
  EXPECT_NE(message_of(sweep).find("phase = 20 values; must have 21"), std::string::npos);
  sweep = sweep_of(2, 1.0);
  sweep.frequency.resize(1);
  EXPECT_NE(message_of(sweep).find("must have at least 2"), std::string::npos);
}

TEST(SteppedSine, SeveralPassagesAreFlagged) {
  SteppedSine sweep = sweep_of(401, 1.0);
  sweep.phase[12] = 3.0;
  sweep.phase[14] = 0.1;
  const ReducedLevel level = reduce_stepped_sine(Reducer(one_mode_rig()), sweep);
  EXPECT_TRUE(level.has_flag("several_resonances"));
}

}  // namespace
}  // namespace microslip::stepped_sine_test
