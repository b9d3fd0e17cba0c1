// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/modal_observer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "support/rigs.hpp"

namespace microslip::modal_observer_test {
namespace {

using Complex = std::complex<double>;

constexpr double kOmega = 2.0 * std::numbers::pi * 55.3;
constexpr std::size_t kHarmonics = 10;

Complex draw(RandomStream& random) {
  const double real = random.normal();
  return {real, random.normal()};
}

FourierSeries zero_series() {
  FourierSeries series;
  series.omega = kOmega;
  series.harmonic.assign(kHarmonics, 0.0);
  return series;
}

/// A motion by the equation of StickState, without shortening, for a drawn force and joint.
struct Motion {
  FourierSeries force = zero_series();
  FourierSeries joint = zero_series();  // g
  std::vector<FourierSeries> modal;
  std::vector<FourierSeries> acceleration;

  Motion(const StickState& state, std::uint64_t seed) {
    RandomStream random(seed, 0);
    for (std::size_t n = 0; n < kHarmonics; ++n) {
      force.harmonic[n] = draw(random);
      joint.harmonic[n] = draw(random);
    }
    for (std::size_t i = 0; i < state.modes(); ++i) {
      FourierSeries& q = modal.emplace_back(zero_series());
      const double square = state.omega[i] * state.omega[i];
      for (std::size_t n = 0; n < kHarmonics; ++n) {
        const double w = static_cast<double>(n + 1) * kOmega;
        q.harmonic[n] =
            (state.excitation[i] * force.harmonic[n] + state.joint[i] * joint.harmonic[n]) /
            Complex(square - w * w, state.loss_factor[i] * square);
      }
    }
    for (const std::vector<double>& shape : state.accelerometer) {
      FourierSeries& a = acceleration.emplace_back(zero_series());
      for (std::size_t i = 0; i < shape.size(); ++i) {
        for (std::size_t n = 0; n < kHarmonics; ++n) {
          const double w = static_cast<double>(n + 1) * kOmega;
          a.harmonic[n] -= w * w * shape[i] * modal[i].harmonic[n];
        }
      }
    }
  }
};

StickState state_without_shortening(std::size_t modes) {
  StickState state = stick_state(testing::reference_rig(), modes);
  state.shortening.clear();
  return state;
}

/// Error by rounding: motion and joint force cancel to some 1e-3 close to the resonance, and in the
/// higher harmonics the modes do at the accelerometers, to 4 %.
constexpr double kTolerance = 1e-10;

TEST(ModalObserver, FindsTheMotionOfAllModes) {
  const StickState state = state_without_shortening(7);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Motion truth(state, seed);
    const ModalMotion found =
        ModalObserver(state, kOmega, kHarmonics).observe(truth.force, truth.acceleration);
    for (std::size_t i = 0; i < state.modes(); ++i) {
      for (std::size_t n = 1; n <= kHarmonics; ++n) {
        EXPECT_LE(std::abs(found.modal[i].c(n) - truth.modal[i].c(n)),
                  kTolerance * std::abs(truth.modal[i].c(n)))
            << "mode " << i << ", harmonic " << n;
      }
    }
    for (const double misfit : found.misfit) EXPECT_LE(misfit, kTolerance);
  }
}

TEST(ModalObserver, OneAccelerometerIsEnoughForTheFundamental) {
  StickState state = state_without_shortening(7);
  state.accelerometer.resize(1);
  const Motion truth(state, 4);
  const ModalMotion found =
      ModalObserver(state, kOmega, kHarmonics).observe(truth.force, truth.acceleration);
  EXPECT_LE(std::abs(found.modal[0].c(1) - truth.modal[0].c(1)),
            kTolerance * std::abs(truth.modal[0].c(1)));
}

TEST(ModalObserver, JointForceAndKinematicsFollowFromTheMotion) {
  const StickState state = state_without_shortening(7);
  const Motion truth(state, 7);
  const ModalMotion found =
      ModalObserver(state, kOmega, kHarmonics).observe(truth.force, truth.acceleration);
  Complex rotation = 0.0;
  for (std::size_t i = 0; i < state.modes(); ++i) rotation += state.joint[i] * truth.modal[i].c(1);
  const Complex force = state.stiffness * rotation - truth.joint.c(1);  // F_joint = kψq − g
  EXPECT_LE(std::abs(found.joint_force.c(1) - force), kTolerance * std::abs(force));
  const Complex u = rotation - state.axial_compliance * force;
  EXPECT_LE(std::abs(found.kinematic.c(1) - u), kTolerance * std::abs(u));
  EXPECT_NEAR(found.softening, (truth.joint.c(1) / rotation).real(),
              kTolerance * std::abs(truth.joint.c(1) / rotation));
  EXPECT_EQ(found.mean_shortening, 0.0);
}

TEST(ModalObserver, MisfitShowsAWrongSensor) {
  const StickState state = state_without_shortening(7);
  Motion truth(state, 9);
  for (Complex& c : truth.acceleration[2].harmonic) c = -c;
  const ModalMotion found =
      ModalObserver(state, kOmega, kHarmonics).observe(truth.force, truth.acceleration);
  EXPECT_GE(*std::ranges::max_element(found.misfit), 0.5);
}

/// One mode without loss, with sensor, exciter and joint at one place.
StickState one_mode_state(double joint) {
  StickState state;
  state.omega = {kOmega};
  state.loss_factor = {0.0};
  state.excitation = {0.7};
  state.joint = {joint};
  state.accelerometer = {{0.7}};
  state.stiffness = 1e5;
  return state;
}

TEST(ModalObserver, AtTheFrequencyOfAModeWithoutLoss) {
  FourierSeries force = zero_series();
  FourierSeries acceleration = zero_series();
  force.harmonic = {2.0};
  acceleration.harmonic = {Complex(0.0, 30.0)};
  const StickState state = one_mode_state(0.7);
  const ModalMotion found =
      ModalObserver(state, kOmega, 1).observe(force, std::span(&acceleration, 1));
  const Complex q = -acceleration.c(1) / (kOmega * kOmega) / 0.7;
  // 1e-7: the observer counts a frequency this close as 1e-10 off, next to which the force is 1e5
  // times the motion's part and rounded to 1e-16.
  EXPECT_LE(std::abs(found.modal[0].c(1) - q), 1e-7 * std::abs(q));
  // No inertia or stiffness is left: the joint does what the force does, less its own spring.
  const Complex joint_force = state.stiffness * 0.7 * q + force.c(1);
  EXPECT_LE(std::abs(found.joint_force.c(1) - joint_force), 1e-7 * std::abs(joint_force));
}

TEST(ModalObserver, RefusesAJointThatNoAccelerometerSees) {
  EXPECT_THROW(ModalObserver(one_mode_state(0.0), 0.9 * kOmega, 1), InputError);
  StickState still = one_mode_state(0.7);
  still.accelerometer = {{0.0}};
  EXPECT_THROW(ModalObserver(still, 0.9 * kOmega, 1), InputError);
}

TEST(ModalObserver, RefusesWhatDoesNotBelongTogether) {
  const StickState state = state_without_shortening(7);
  const Motion truth(state, 1);
  EXPECT_THROW(ModalObserver(state, 0.0, 3), InputError);
  EXPECT_THROW(ModalObserver(state, kOmega, 0), InputError);
  const ModalObserver observer(state, kOmega, kHarmonics);
  EXPECT_THROW((void)observer.observe(truth.force, std::span(truth.acceleration).first(2)),
               InputError);
  EXPECT_THROW((void)ModalObserver(state, 1.01 * kOmega, kHarmonics)
                   .observe(truth.force, truth.acceleration),
               InputError);
}

}  // namespace
}  // namespace microslip::modal_observer_test
