// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/cycle/harmonic_force.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/structures.hpp"

/// @file
/// Public functions of dynamics/ with arguments that mean nothing: a documented value or
/// InputError. Those of the march are in march_rules_test.cpp, those of structures in
/// harmonic_balance_rules_test.cpp.

namespace microslip::any_argument_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(AnyArgument, OfHarmonicForces) {
  HarmonicForce force(2, 32);
  const Joint joint = testing::iwan_joint();
  std::vector<double> x(5, 0.1);
  std::vector<double> f(5);
  std::vector<double> jacobian(25);
  EXPECT_NO_THROW((void)force.evaluate(joint, x, f, jacobian));
  EXPECT_THROW((void)force.evaluate(joint, {}, f, jacobian), InputError);
  EXPECT_THROW((void)force.evaluate(joint, x, {}, jacobian), InputError);
  EXPECT_THROW((void)force.evaluate(joint, x, f, {}), InputError);
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    x[3] = bad;
    EXPECT_THROW((void)force.evaluate(joint, x, f, jacobian), InputError);
  }
  for (const auto& [harmonics, samples] : {std::pair{0, 32}, {1001, 4096}, {2, 5}, {2, 1000001}}) {
    EXPECT_THROW(
        HarmonicForce(static_cast<std::size_t>(harmonics), static_cast<std::size_t>(samples)),
        InputError);
  }
}

TEST(AnyArgument, OfBalances) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"},
                                {.harmonics = 1, .samples = 32});
  const Target good{Quantity::kAngularFrequency, 0.8};
  for (const Quantity quantity : {Quantity::kForceAmplitude, Quantity::kResponse}) {
    for (const double bad : {kNaN, kInfinity, -kInfinity, -1.0, 0.0}) {
      EXPECT_THROW((void)balance.solve(good, {quantity, bad}), InputError);
    }
  }
  for (const double bad : {kNaN, kInfinity, -1.0, 0.0, 4.0}) {
    EXPECT_THROW((void)balance.solve({Quantity::kPhaseLag, bad}, good), InputError);
  }
  EXPECT_THROW((void)balance.solve(kPhaseResonance, {Quantity::kResponse, 1.0}, 7), InputError);
  for (const double bad : {kNaN, kInfinity, -1.0, 0.0}) {
    EXPECT_THROW((void)balance.frequency_response(bad, 0.5, 1.5), InputError);
    EXPECT_THROW((void)balance.frequency_response(0.1, bad, 1.5), InputError);
    EXPECT_THROW((void)balance.frequency_response(0.1, 0.5, bad), InputError);
    EXPECT_THROW((void)balance.constant_response(bad, 0.5, 1.5), InputError);
    EXPECT_THROW((void)balance.backbone(std::vector{0.1, bad}), InputError);
  }
  EXPECT_THROW((void)balance.backbone({}), InputError);
  EXPECT_THROW((void)balance.backbone(std::vector{0.1}, 7), InputError);
  EXPECT_THROW((void)balance.follow(good, Quantity::kPhaseLag, 1.0, 2.0), InputError);
  const Target force{Quantity::kForceAmplitude, 0.1};
  EXPECT_THROW((void)balance.solve(good, force, SteadyVibration{}), InputError);
}

TEST(AnyArgument, OfVibrations) {
  const ModalModel model({{1.0, 0.1}, {2.0, 0.1}}, {{"a", {1.0, 0.5}}});
  SteadyVibration vibration;
  vibration.angular_frequency = 1.0;
  vibration.modal = {{}, {}};
  EXPECT_EQ(vibration.damping_ratio(), 0.0) << "no first harmonic";
  EXPECT_TRUE(vibration.displacement(model, "a").empty());
  vibration.modal = {{0.0, 1.0}};
  EXPECT_THROW((void)vibration.displacement(model, "a"), InputError) << "modes of another model";
  vibration.modal = {{0.0, 1.0}, {0.0}};
  EXPECT_THROW((void)vibration.acceleration(model, "a"), InputError);
  vibration.modal = {{0.0, 1.0}, {0.0, 1.0}, {0.0, 1.0}};
  EXPECT_THROW((void)vibration.displacement(model, "a"), InputError);
  vibration.modal = {{0.0, 1.0}, {0.0, 1.0}};
  EXPECT_THROW((void)vibration.displacement(model, "b"), InputError);
}

}  // namespace
}  // namespace microslip::any_argument_test
