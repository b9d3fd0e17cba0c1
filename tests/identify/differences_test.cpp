// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/differences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip::differences_test {
namespace {

constexpr double kStiffness = 2e5;  // N/m

/// φ = 1/50 + (f* − 25)/2500 on [0, 50] N.
Joint ramp_joint() {
  return Joint(kStiffness, SlipDensity({PiecewiseLinearPart{{0.0, 50.0}, {0.01, 0.03}}}));
}

Levels levels_of(const Joint& joint, const std::vector<double>& amplitude) {
  Levels levels;
  levels.amplitude = amplitude;
  for (const double a : amplitude) levels.dissipation.push_back(dissipation(joint, a));
  return levels;
}

// With φ uniform D is a cubic, whose second difference is that at the mean of its three points.
TEST(Differences, ExactForUniformDensity) {
  const Joint joint(kStiffness, SlipDensity({UniformPart{0.0, 100.0, 0.8}}));
  const std::vector<double> a{1e-6, 3e-6, 4e-6, 1e-5, 1.2e-5, 1.3e-5};
  const SignedDensity result = density_by_differences(levels_of(joint, a), kStiffness);
  ASSERT_EQ(result.slip_force.size(), 4U);
  EXPECT_TRUE(result.standard_deviation.empty());
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    EXPECT_DOUBLE_EQ(result.slip_force[i - 1], kStiffness * a[i]);
    const double shifted = 0.008 * (a[i - 1] + a[i] + a[i + 1]) / (3.0 * a[i]);
    EXPECT_NEAR(result.density[i - 1], shifted, 1e-12);  // rounding of D over the square of a gap
  }
}

// Of second order where the spacing is equal: halving it divides the error by 4, here up to the
// next order.
TEST(Differences, ConvergesWithTheSpacing) {
  const Joint joint = ramp_joint();
  const auto error_with = [&](int n) {
    std::vector<double> a;
    for (int i = 1; i <= n; ++i) a.push_back(2e-4 * i / n);
    const SignedDensity result = density_by_differences(levels_of(joint, a), kStiffness);
    const auto middle = static_cast<std::size_t>(n / 2 - 2);
    return std::abs(result.density[middle] - joint.density().density(result.slip_force[middle]));
  };
  EXPECT_NEAR(std::log2(error_with(20) / error_with(40)), 2.0, 0.2);
}

TEST(Differences, OrderAndRepetitionAreFree) {
  const Joint joint = ramp_joint();
  const Levels sorted = levels_of(joint, {1e-5, 2e-5, 4e-5, 5e-5});
  const Levels shuffled = levels_of(joint, {4e-5, 1e-5, 5e-5, 4e-5, 2e-5});
  const SignedDensity a = density_by_differences(sorted, kStiffness);
  const SignedDensity b = density_by_differences(shuffled, kStiffness);
  EXPECT_EQ(a.slip_force, b.slip_force);
  for (std::size_t i = 0; i < a.density.size(); ++i) {
    EXPECT_NEAR(a.density[i], b.density[i], 1e-12);
  }
}

// The standard deviation of 4000 draws is within 4/√(2·4000) = 4.5 % of its own.
TEST(Differences, NoiseBecomesWhatIsReported) {
  const Levels clean = levels_of(ramp_joint(), {1e-5, 2e-5, 4e-5, 5e-5, 9e-5});
  const std::vector<double> sigma{1e-8, 3e-8, 2e-8, 5e-8, 1e-8};
  const SignedDensity truth = density_by_differences(clean, kStiffness);
  std::vector<double> squares(3, 0.0);
  std::vector<double> reported;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    RandomStream random(seed, 0);
    Levels noisy = clean;
    noisy.dissipation_std = sigma;
    for (std::size_t i = 0; i < 5; ++i) {
      noisy.dissipation[i] = std::abs(clean.dissipation[i] + 1e-3 * sigma[i] * random.normal());
    }
    const SignedDensity result = density_by_differences(noisy, kStiffness);
    reported = result.standard_deviation;
    for (std::size_t i = 0; i < 3; ++i) {
      squares[i] += std::pow(1e3 * (result.density[i] - truth.density[i]), 2) / 4000.0;
    }
  }
  ASSERT_EQ(reported.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(std::sqrt(squares[i]) / reported[i], 1.0, 0.045);
}

TEST(Differences, RefusesWhatItCannotUse) {
  const Levels two = levels_of(ramp_joint(), {1e-5, 2e-5, 2e-5});
  try {
    (void)density_by_differences(two, kStiffness);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "number of distinct amplitudes = 2; must be at least 3 for second differences. "
              "Measure more levels");
  }
  EXPECT_THROW((void)density_by_differences(levels_of(ramp_joint(), {1e-5, 2e-5, 3e-5}), -1.0),
               InputError);
}

}  // namespace
}  // namespace microslip::differences_test
