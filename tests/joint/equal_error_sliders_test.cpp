// SPDX-License-Identifier: MIT
#include "microslip/joint/equal_error_sliders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::equal_error_sliders_test {
namespace {

constexpr double kStiffness = 1e7;  // N/m

struct Density {
  std::string name;
  std::vector<DensityPart> parts;
  /// The error over that of equal steps, at most. Where φ is constant equal steps are wrong by as
  /// much everywhere too, but on one side of F: the band F ± ε gains a half of many elements.
  double gain = 0.25;
};

std::vector<Density> densities() {
  return {{"constant", {UniformPart{0.0, 5000.0, 1.0}}, 0.6},
          {"constant from 2000 N", {UniformPart{2000.0, 5000.0, 0.7}}},
          {"power −1/2", {PowerLawPart{0.5 / std::sqrt(5000.0), -0.5, 0.0, 5000.0}}},
          {"power −0.9", {PowerLawPart{0.1 / std::pow(5000.0, 0.1), -0.9, 0.0, 5000.0}}},
          {"two constants", {UniformPart{0.0, 300.0, 0.5}, UniformPart{3000.0, 9000.0, 0.4}}},
          {"falling, and atoms",
           {PiecewiseLinearPart{{0.0, 100.0, 1000.0, 20000.0}, {2e-4, 1e-4, 2e-5, 0.0}},
            AtomsPart{{3000.0}, {0.1}}}}};
}

Joint joint_of_parts(const Density& density) {
  return Joint(kStiffness, SlipDensity(density.parts));
}

/// Sliders in the middle of steps of equal width, each with the weight of its step.
Joint equal_steps(const Joint& joint, std::size_t n) {
  const SlipDensity& density = joint.density();
  const double end = density.largest_slip_force();
  std::vector<JenkinsElement> elements;
  double below = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double upper = end * static_cast<double>(i + 1) / static_cast<double>(n);
    const double weight = density.moments(upper * (1.0 + 1e-12)).zeroth - below;
    below += weight;
    const double middle = end * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    if (weight > 0.0) elements.push_back({kStiffness * weight, weight * middle});
  }
  return joint_of(JenkinsNetwork(elements, kStiffness * density.elastic_remainder()));
}

/// The largest error of F on a grid of equal steps and on one of equal ratios.
double largest_error(const Joint& joint, const Joint& sliders, double to) {
  constexpr int kPoints = 20000;
  double largest = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double even = to * i / kPoints;
    const double logarithmic = to * std::exp(-16.0 * i / kPoints);
    for (const double x : {even, logarithmic}) {
      largest = std::max(largest, std::abs(sliders.virgin_force(x) - joint.virgin_force(x)));
    }
  }
  return largest;
}

// A grid of 20 000 points misses at most 1e-3 of a largest error between kinks.
TEST(EqualErrorSliders, AreWrongByWhatTheySay) {
  for (const Density& density : densities()) {
    const Joint joint = joint_of_parts(density);
    const double end = joint.density().largest_slip_force() / kStiffness;
    for (const std::size_t n : {3U, 5U, 20U, 50U}) {
      const EqualErrorSliders chosen = equal_error_sliders(joint, n);
      const Joint sliders = joint_of(chosen.network);
      const double found = largest_error(joint, sliders, 1.2 * end);
      EXPECT_LE(found, chosen.error * (1.0 + 1e-6)) << density.name << " " << n;
      EXPECT_GE(found, chosen.error * 0.999) << density.name << " " << n;
      EXPECT_EQ(chosen.network.size(), n) << density.name;
      EXPECT_NEAR(sliders.stiffness(), kStiffness, 1e-12 * kStiffness) << density.name;
      EXPECT_NEAR(sliders.macroslip_force(), joint.macroslip_force(),
                  1e-12 * joint.macroslip_force())
          << density.name;
    }
  }
}

TEST(EqualErrorSliders, AreBetterThanEqualSteps) {
  for (const Density& density : densities()) {
    const Joint joint = joint_of_parts(density);
    const double end = joint.density().largest_slip_force() / kStiffness;
    for (const std::size_t n : {5U, 10U, 20U, 50U}) {
      const EqualErrorSliders chosen = equal_error_sliders(joint, n);
      EXPECT_LE(chosen.error, density.gain * largest_error(joint, equal_steps(joint, n), 1.2 * end))
          << density.name << " " << n;
    }
  }
}

TEST(EqualErrorSliders, OfOneElementHoldTheLargestForce) {
  const Joint joint(kStiffness, SlipDensity({UniformPart{0.0, 100.0, 1.0}}));
  const EqualErrorSliders chosen = equal_error_sliders(joint, 1);
  ASSERT_EQ(chosen.network.size(), 1U);
  // k up to f/2 at x = f/(2k): F is f/2 − f/8 there.
  EXPECT_NEAR(chosen.network.slip_displacement()[0], 50.0 / kStiffness, 1e-18);
  EXPECT_NEAR(chosen.error, 100.0 / 8.0, 1e-4);
}

TEST(EqualErrorSliders, KeepAtomsAlone) {
  const Joint joint(kStiffness, SlipDensity({AtomsPart{{10.0, 30.0, 20.0}, {0.2, 0.3, 0.1}}}));
  const EqualErrorSliders chosen = equal_error_sliders(joint, 7);
  EXPECT_EQ(chosen.network.size(), 3U);
  EXPECT_EQ(chosen.error, 0.0);
  EXPECT_NEAR(chosen.network.elastic_stiffness(), 0.4 * kStiffness, 1e-9 * kStiffness);
  EXPECT_THROW((void)equal_error_sliders(joint, 2), InputError);
}

TEST(EqualErrorSliders, TakeWhatSlipsBeyondTheReachForASpring) {
  const Joint joint(
      kStiffness, SlipDensity({UniformPart{0.0, 100.0, 0.5}, AtomsPart{{20.0, 80.0}, {0.1, 0.2}}}));
  constexpr double kReach = 50.0 / kStiffness;
  const EqualErrorSliders chosen = equal_error_sliders(joint, 9, kReach);
  const Joint sliders = joint_of(chosen.network);
  EXPECT_EQ(chosen.network.size(), 9U);
  EXPECT_NEAR(chosen.network.elastic_stiffness(), (0.2 + 0.25 + 0.2) * kStiffness,
              1e-9 * kStiffness);
  EXPECT_LE(largest_error(joint, sliders, kReach), chosen.error * (1.0 + 1e-6));
  EXPECT_LT(chosen.error, equal_error_sliders(joint, 10).error / 3.0);
  EXPECT_THROW((void)equal_error_sliders(joint, 9, 0.0), InputError);
  EXPECT_THROW((void)equal_error_sliders(joint, 9, std::nan("")), InputError);
}

TEST(EqualErrorSliders, OfAJointThatNeverSlipsAreASpring) {
  const EqualErrorSliders chosen = equal_error_sliders(Joint(kStiffness, SlipDensity()), 5);
  EXPECT_EQ(chosen.network.size(), 0U);
  EXPECT_EQ(chosen.network.elastic_stiffness(), kStiffness);
  EXPECT_EQ(joint_of(chosen.network).virgin_force(1e-3), 1e-3 * kStiffness);
}

}  // namespace
}  // namespace microslip::equal_error_sliders_test
