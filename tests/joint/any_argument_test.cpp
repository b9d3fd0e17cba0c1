// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/covered_range.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/joint/power_law.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/joint/virgin_curve.hpp"

/// @file
/// Each public function of joint/ with invalid arguments: a documented value or InputError, never a
/// place outside of a table. The sanitizers look on.

namespace microslip::any_argument_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kHuge = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// With one knot per bucket and with many, of each kind of part, with and without a remainder.
std::vector<Joint> joints() {
  std::vector<double> crowd;
  std::vector<double> weight;
  for (int i = 0; i < 300; ++i) {
    crowd.push_back(std::pow(10.0, -12.0 + 0.05 * i));
    weight.push_back(1.0 / 300.0);
  }
  std::vector<Joint> all;
  all.emplace_back(1e5, SlipDensity());
  all.emplace_back(1e5, SlipDensity({UniformPart{0.0, 5.0, 1.0}}));
  all.emplace_back(1e5, SlipDensity({UniformPart{2.0, 7.0, 0.8}}));
  all.emplace_back(1e5, SlipDensity({PowerLawPart{0.1, -0.5, 0.0, 25.0}}));
  all.emplace_back(1e5, SlipDensity({AtomsPart{{1.0, 8.0}, {0.5, 0.5}}}));
  all.emplace_back(1e5, SlipDensity({AtomsPart{crowd, weight}}));
  all.push_back(Joint::four_parameter(30.0, 1e5, -0.3, 0.2));
  return all;
}

TEST(AnyArgument, OfTheVirginCurve) {
  for (const Joint& joint : joints()) {
    EXPECT_TRUE(std::isnan(joint.virgin_force(kNaN)));
    EXPECT_TRUE(std::isnan(joint.virgin_force(-kNaN)));
    EXPECT_TRUE(std::isnan(joint.tangent_stiffness(kNaN)));
    const double remainder = joint.density().elastic_remainder();
    const double limit = remainder > 0.0 ? kInfinity : joint.macroslip_force();
    for (const double x : {kInfinity, kHuge}) {  // k times the largest number is none
      EXPECT_EQ(joint.virgin_force(x), limit);
      EXPECT_EQ(joint.virgin_force(-x), -limit);
      EXPECT_EQ(joint.tangent_stiffness(x), 1e5 * remainder);
      EXPECT_EQ(joint.tangent_stiffness(-x), 1e5 * remainder);
    }
    EXPECT_EQ(joint.virgin_force(0.0), 0.0);
    EXPECT_EQ(joint.tangent_stiffness(0.0), 1e5);
  }
}

TEST(AnyArgument, OfTheBackbone) {
  for (const Joint& joint : joints()) {
    const VirginCurve& curve = joint.virgin_curve();
    EXPECT_TRUE(std::isnan(curve.force(kNaN)));
    EXPECT_TRUE(std::isnan(curve.force(kInfinity)));
    EXPECT_TRUE(std::isnan(curve.slope(kNaN)));
    for (const double s : {-kTiny, -1.0, -1e9, -kHuge, -kInfinity}) {
      EXPECT_EQ(curve.force(s), curve.force(0.0)) << s;
      EXPECT_EQ(curve.slope(s), curve.slope(0.0)) << s;
    }
    const std::array<double, 7> x{0.0, kNaN, kInfinity, -kInfinity, kHuge, -kHuge, 1e-5};
    std::array<double, 7> force{};
    for (const double scale : {1e5, -1e5, kNaN, kInfinity, 0.0}) {
      curve.branch_forces({0.0, 1.0, scale, 2.0}, x, force);
      if (scale == 1e5) {
        EXPECT_EQ(force[0], 1.0);
        EXPECT_TRUE(std::isnan(force[1]));
        EXPECT_TRUE(std::isnan(force[2]));
        EXPECT_EQ(force[6], 1.0 + 2.0 * curve.force(1.0));
      }
      if (scale == -1e5) {
        EXPECT_EQ(force[6], 1.0) << "below 0 as at 0";
      }
    }
    EXPECT_THROW(curve.branch_forces({}, x, std::span(force).first(6)), InputError);
    EXPECT_NO_THROW(curve.branch_forces({}, {}, {}));
  }
}

TEST(AnyArgument, OfTheDensity) {
  for (const Joint& joint : joints()) {
    const SlipDensity& density = joint.density();
    EXPECT_TRUE(std::isnan(density.density(kNaN)));
    EXPECT_TRUE(std::isnan(density.moments(kNaN).zeroth));
    EXPECT_TRUE(std::isnan(density.moments(kNaN).first));
    EXPECT_TRUE(std::isnan(density.moments(kNaN).second));
    EXPECT_TRUE(std::isnan(density.slip_energy(kNaN)));
    EXPECT_EQ(density.moments(kInfinity).zeroth, density.total().zeroth);
    EXPECT_EQ(density.density(kInfinity), 0.0);
    EXPECT_EQ(density.slip_energy(kInfinity), density.total().first > 0.0 ? kInfinity : 0.0);
    for (const double s : {-kTiny, -1.0, -kInfinity}) {
      EXPECT_EQ(density.density(s), 0.0);
      EXPECT_EQ(density.moments(s).first, 0.0);
      EXPECT_EQ(density.slip_energy(s), 0.0);
    }
  }
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1.0}) {
    EXPECT_THROW(SlipDensity({UniformPart{bad, 1.0, 0.5}}), InputError);
    EXPECT_THROW(SlipDensity({UniformPart{0.0, bad, 0.5}}), InputError);
    EXPECT_THROW(SlipDensity({UniformPart{0.0, 1.0, bad}}), InputError);
    EXPECT_THROW(SlipDensity({PowerLawPart{bad, 0.0, 0.0, 1.0}}), InputError);
    EXPECT_THROW(SlipDensity({PowerLawPart{0.1, bad, 0.0, 1.0}}), InputError);
    EXPECT_THROW(SlipDensity({AtomsPart{{bad}, {0.1}}}), InputError);
    EXPECT_THROW(SlipDensity({AtomsPart{{1.0}, {bad}}}), InputError);
    EXPECT_THROW(SlipDensity({PiecewiseLinearPart{{0.0, bad}, {0.1, 0.1}}}), InputError);
    EXPECT_THROW(SlipDensity({PiecewiseLinearPart{{0.0, 1.0}, {0.1, bad}}}), InputError);
    EXPECT_THROW((void)Joint::four_parameter(bad, 1.0, -0.5, 0.0), InputError);
    EXPECT_THROW((void)Joint::four_parameter(1.0, bad, -0.5, 0.0), InputError);
    EXPECT_THROW((void)Joint::four_parameter(1.0, 1.0, bad, 0.0), InputError);
    EXPECT_THROW((void)Joint::four_parameter(1.0, 1.0, -0.5, bad), InputError);
    EXPECT_THROW(Joint(bad, SlipDensity()), InputError);
  }
  EXPECT_THROW(SlipDensity({PiecewiseLinearPart{{}, {}}}), InputError);
  EXPECT_THROW(SlipDensity({PiecewiseLinearPart{{0.0, 1.0}, {0.1}}}), InputError);
  EXPECT_THROW(SlipDensity({AtomsPart{{}, {}}}), InputError);
  EXPECT_THROW(SlipDensity({AtomsPart{{1.0}, {}}}), InputError);
}

TEST(AnyArgument, OfDissipationAndSecant) {
  for (const Joint& joint : joints()) {
    for (const double bad : {kNaN, kInfinity, -kInfinity, -1e-9}) {
      EXPECT_THROW((void)dissipation(joint, bad), InputError);
      EXPECT_THROW((void)dissipation_slope(joint, bad), InputError);
      EXPECT_THROW((void)dissipation_curvature(joint, bad), InputError);
      EXPECT_THROW((void)secant_stiffness(joint, bad), InputError);
      EXPECT_THROW((void)loss_factor(joint, bad), InputError);
    }
    for (const double a : {0.0, kTiny, 1e-300, 1e-170, 1e160, 1e300, kHuge}) {
      EXPECT_GE(dissipation(joint, a), 0.0) << a;
      EXPECT_GE(dissipation_slope(joint, a), 0.0) << a;
      EXPECT_GE(secant_stiffness(joint, a), 0.0) << a;
      EXPECT_LE(secant_stiffness(joint, a), 1e5) << a;
    }
    for (const double a : {0.0, kTiny, 1e-300, 1e-170, 1e160}) {
      EXPECT_GE(loss_factor(joint, a), 0.0) << a;
    }
  }
  EXPECT_TRUE(std::isnan(jenkins_secant(kNaN)));
  EXPECT_EQ(jenkins_secant(-kInfinity), 0.0);
  EXPECT_EQ(jenkins_secant(kInfinity), 1.0);
}

TEST(AnyArgument, OfMemories) {
  for (const Joint& joint : joints()) {
    Memory memory(joint);
    memory.advance(1e-4);
    memory.advance(-5e-5);
    const double force = memory.force();
    std::vector<double> some(3);
    for (const double bad : {kNaN, kInfinity, -kInfinity, kHuge, -kHuge}) {
      EXPECT_THROW((void)memory.trial(bad), InputError);
      EXPECT_THROW((void)memory.advance(bad), InputError);
      EXPECT_THROW((void)memory.dissipation(bad), InputError);
      EXPECT_THROW(memory.march(std::vector{0.0, bad, 0.0}, some), InputError);
    }
    EXPECT_THROW(memory.march(std::vector{0.0, 0.0}, some), InputError);
    EXPECT_NO_THROW(memory.march({}, {}));
    EXPECT_EQ(memory.force(), force) << "no step is taken";
    EXPECT_EQ(memory.displacement(), -5e-5);
    for (const double near : {kTiny, -kTiny}) (void)memory.trial(near);
    EXPECT_GT(memory.stored_energy(), 0.0);
  }
}

TEST(AnyArgument, OfNetworks) {
  const std::vector<JenkinsElement> good{{1.0, 1.0}};
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1.0}) {
    EXPECT_THROW(JenkinsNetwork(good, bad), InputError);
    EXPECT_THROW(JenkinsNetwork(std::vector<JenkinsElement>{{bad, 1.0}}), InputError);
    EXPECT_THROW(JenkinsNetwork(std::vector<JenkinsElement>{{1.0, bad}}), InputError);
  }
  EXPECT_THROW(JenkinsNetwork({}), InputError);
  for (const Joint& joint : joints()) {
    EXPECT_THROW((void)JenkinsNetwork::discretise(joint, 0), InputError);
    EXPECT_THROW((void)JenkinsNetwork::discretise(joint, static_cast<std::size_t>(-1)), InputError);
    const JenkinsNetwork network = JenkinsNetwork::discretise(joint, 301);
    for (const NormalLoadLaw law : {NormalLoadLaw::kIncremental, NormalLoadLaw::kTotal}) {
      NetworkMemory memory(network, law);
      std::vector<double> force(2);
      for (const double bad : {kNaN, kInfinity, -kInfinity}) {
        EXPECT_THROW((void)memory.advance(bad), InputError);
        EXPECT_THROW((void)memory.advance(0.0, bad), InputError);
        EXPECT_THROW(memory.march(std::vector{0.0, bad}, force), InputError);
        EXPECT_THROW(memory.march(std::vector{0.0, 1.0}, std::vector{bad, 1.0}, force), InputError);
      }
      EXPECT_THROW((void)memory.advance(0.0, -1.0), InputError);
      EXPECT_THROW(memory.march(std::vector{0.0}, force), InputError);
      EXPECT_THROW(memory.march(std::vector{0.0, 1.0}, std::vector{1.0}, force), InputError);
      EXPECT_NO_THROW(memory.march({}, {}));
    }
  }
}

// Internal integrals end, whatever the part and the limit; nothing is promised of their value where
// the part breaks the rules of SlipDensity.
TEST(AnyArgument, OfPowerLaws) {
  const std::vector<double> values{kNaN,  kInfinity, -kInfinity, kHuge, -kHuge,
                                   kTiny, 0.0,       -1.0,       2.0};
  for (const double exponent : values) {
    for (const double from : values) {
      for (const double to : values) {
        for (const double s : values) {
          const PowerLawPart part{1.0, exponent, from, to};
          (void)power_law_moments(part, s);
          (void)power_law_weight(part, s);
          (void)power_law_force_deficit(part, s);
          (void)power_law_slip_energy(part, s);
        }
      }
    }
  }
  const PowerLawPart part{0.1, -0.5, 1.0, 25.0};
  for (const double s : {-kInfinity, -1.0, 0.0, 0.5}) {
    EXPECT_EQ(power_law_weight(part, s), 0.0);
    EXPECT_EQ(power_law_slip_energy(part, s), 0.0);
  }
}

TEST(AnyArgument, OfTheCoveredRange) {
  for (const Joint& joint : joints()) {
    EXPECT_FALSE(beyond_identification(joint, kNaN, 10.0));
    EXPECT_FALSE(beyond_identification(joint, 1.0, kNaN));
    EXPECT_FALSE(beyond_identification(joint, 1.0, std::nullopt));
    EXPECT_TRUE(beyond_identification(joint, kInfinity, 10.0));
  }
}

}  // namespace
}  // namespace microslip::any_argument_test
