// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "support/rigs.hpp"

/// @file Records whose joint displacement turns more than twice a cycle, from samples to the flag.
///
/// u = A(cos ωt + b cos 2ωt) has an inner loop around ωt = π where b > 1/4, of the depth
///
///     A (1 − 4b)²/(8b).

namespace microslip::inner_reversals_test {
namespace {

using testing::Sampling;
using testing::SolvedRig;
using testing::unseen_rig;

constexpr double kAmplitude = 1e-4;  // A, m
constexpr int kHarmonics = 10;       // that are fitted, as a rule
constexpr std::size_t kLevel = 30;   // of the solved rig; only force and accelerations are used
constexpr Sampling kSampling;

/// b of a depth in m, by the closed form.
double second_harmonic(double depth) {
  const double d = depth / kAmplitude;
  return 0.25 + 0.25 * (d + std::sqrt(2.0 * d + d * d));  // 16b² − (8 + 8d)b + 1 = 0
}

/// Least depth that counts: 4√2 standard deviations of the fitted series, whose 2H coefficients
/// have the variance 2σ²/N each.
double threshold() {
  const double points = static_cast<double>(kSampling.points);
  return 4.0 * std::numbers::sqrt2 * kSampling.vibrometer_noise *
         std::sqrt(2.0 * kHarmonics / points);
}

Recording record_with_inner_loop(double depth, std::uint64_t seed) {
  static const SolvedRig kSolved(MICROSLIP_TEST_DATA "/unseen_rig.csv");
  Recording recording = kSolved.record(kLevel, kSampling, seed);
  RandomStream random(seed, 1000);
  std::vector<double>& u = recording.channels.back().values;
  const double b = second_harmonic(depth);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * kSolved.frequency[kLevel] * recording.axis.at(i);
    u[i] = kAmplitude * (std::cos(angle) + b * std::cos(2.0 * angle)) +
           kSampling.vibrometer_noise * random.normal();
  }
  return recording;
}

TEST(InnerReversals, DepthIsThatOfTheClosedForm) {
  for (const double depth : {1e-9, 1e-8, 1e-5}) {
    const double b = second_harmonic(depth);
    const double in_loop = -1.0 + b;  // at ωt = π
    const double beside = -1.0 / (8.0 * b) - b;
    // Differences of numbers near A, to rounding.
    EXPECT_NEAR(kAmplitude * (in_loop - beside), depth, 1e-15 * kAmplitude);
  }
}

TEST(InnerReversals, AboveTheNoiseAreCountedAndFlagged) {
  const Reducer reducer(unseen_rig());
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    // Twice the threshold: chance adds a quarter of it, √2 σ, with one standard deviation.
    const ReducedLevel level = reducer.reduce(record_with_inner_loop(2.0 * threshold(), seed));
    EXPECT_EQ(level.reversals, 4U);
    EXPECT_TRUE(level.has_flag(kInnerReversals));
    // Half the way from one extreme to the other: the loop lies at one of them.
    const double b = second_harmonic(2.0 * threshold());
    EXPECT_NEAR(level.amplitude.value, 0.5 * kAmplitude * (1.0 + 2.0 * b + 1.0 / (8.0 * b)),
                0.5 * threshold());
  }
}

TEST(InnerReversals, BelowTheNoiseAreNone) {
  const Reducer reducer(unseen_rig());
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    // A quarter of the threshold: chance makes up the rest, three standard deviations, hardly ever.
    const ReducedLevel level = reducer.reduce(record_with_inner_loop(0.25 * threshold(), seed));
    EXPECT_EQ(level.reversals, 2U);
    EXPECT_FALSE(level.has_flag(kInnerReversals));
  }
}

TEST(InnerReversals, AreNotSoughtInAVibrometerThatIsNotUsed) {
  const Reducer reducer(unseen_rig(), {.use_vibrometer = false});
  const ReducedLevel level = reducer.reduce(record_with_inner_loop(1e-5, 1));
  EXPECT_EQ(level.reversals, 2U);
}

}  // namespace
}  // namespace microslip::inner_reversals_test
