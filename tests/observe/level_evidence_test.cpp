// SPDX-License-Identifier: MIT
#include "microslip/observe/level_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip::level_evidence_test {
namespace {

const Joint kJoint(1e5, SlipDensity({UniformPart{.from = 0.0, .to = 20.0, .weight = 0.8}}));

/// Twelve levels of kJoint, without noise.
Levels exact_levels(bool secant = false) {
  Levels levels;
  for (int i = 1; i <= 12; ++i) {
    const double a = 1e-5 * i;
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(kJoint, a));
    if (secant) levels.secant_stiffness.push_back(secant_stiffness(kJoint, a));
  }
  return levels;
}

void give_deviations(double share, Levels& levels) {
  for (const double d : levels.dissipation) levels.dissipation_std.push_back(share * d);
  for (const double k : levels.secant_stiffness) levels.secant_stiffness_std.push_back(share * k);
}

LevelPrediction of_joint(const LevelEvidence& evidence, const Joint& joint) {
  return {.value = evidence.predict(joint), .change = evidence.amplitude_change(joint)};
}

// D of a uniform density by hand: D = 4∫ s(A − s)(φ k²)… = (2/3) φ k² A³ with φ = 0.8/20 N.
TEST(LevelEvidence, PredictsByTheJoint) {
  const LevelEvidence evidence(exact_levels(true));
  const LevelRows rows = evidence.predict(kJoint, 3.0);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const double a = evidence.levels().amplitude[i];
    const double expected = 2.0 / 3.0 * 0.04 * 1e10 * a * a * a + 3.0 * a * a;
    EXPECT_NEAR(rows.dissipation[i], expected, 1e-12 * expected);
    EXPECT_EQ(rows.secant_stiffness[i], secant_stiffness(kJoint, a));
  }
  EXPECT_TRUE(LevelEvidence(exact_levels()).predict(kJoint).secant_stiffness.empty());
}

// Given deviations are combined with the scatter found, and with the effect of ± σ_A on D ∝
// A³: ½((A + σ)³ − (A − σ)³) = 3A²σ + σ³.
TEST(LevelEvidence, DeviationsGivenAddToThoseOfTheAmplitude) {
  Levels levels = exact_levels(true);
  give_deviations(0.01, levels);
  for (const double a : levels.amplitude) levels.amplitude_std.push_back(0.1 * a);
  const LevelEvidence evidence(levels);
  EXPECT_TRUE(evidence.amplitude_std_counts());
  const LevelRows sigma = evidence.deviations(of_joint(evidence, kJoint), {2.0, 3.0});
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const double d = levels.dissipation[i];
    EXPECT_NEAR(sigma.dissipation[i], 2.0 * std::hypot(0.01 * d, 0.301 * d), 1e-12 * d);
    const double a = levels.amplitude[i];
    const double k = levels.secant_stiffness[i];
    const double change =
        0.5 * std::abs(secant_stiffness(kJoint, 1.1 * a) - secant_stiffness(kJoint, 0.9 * a));
    EXPECT_NEAR(sigma.secant_stiffness[i], 3.0 * std::hypot(0.01 * k, change), 1e-12 * k);
  }
}

// A share of D as predicted, not as measured, and one σ of all k_eq; an estimated scatter includes
// that of the amplitude.
TEST(LevelEvidence, UnknownDeviationsAreAShareOfThePrediction) {
  Levels levels = exact_levels(true);
  levels.dissipation[5] *= 0.1;
  for (const double a : levels.amplitude) levels.amplitude_std.push_back(0.1 * a);
  const LevelEvidence evidence(levels);
  EXPECT_FALSE(evidence.amplitude_std_counts());
  const LevelPrediction prediction = of_joint(evidence, kJoint);
  const LevelRows sigma = evidence.deviations(prediction, {0.02, 90.0});
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    EXPECT_DOUBLE_EQ(sigma.dissipation[i], 0.02 * prediction.value.dissipation[i]);
    EXPECT_EQ(sigma.secant_stiffness[i], 90.0);
  }
  const LevelRows residual = evidence.residuals(prediction.value, sigma);
  EXPECT_NEAR(residual.dissipation[5], -0.9 / 0.02, 1e-9);
  EXPECT_NEAR(residual.dissipation[6], 0.0, 1e-9);
}

// A level below the floor counts as one there: its σ does not fall with it.
TEST(LevelEvidence, LevelsBelowTheFloorDoNotRule) {
  for (const bool given : {false, true}) {
    Levels levels = exact_levels();
    levels.dissipation[0] = 0.0;
    if (given) give_deviations(0.01, levels);
    if (given) levels.dissipation_std[0] = 1e-20;
    const LevelEvidence evidence(levels);
    const double floor = evidence.dissipation_floor()[0];
    EXPECT_NEAR(floor, 1e-3 * levels.dissipation[11] / std::pow(12.0, 3), 1e-12 * floor);
    LevelPrediction prediction{.value = {.dissipation = levels.dissipation}};
    const LevelRows sigma = evidence.deviations(prediction, {given ? 1.0 : 0.01, 1.0});
    EXPECT_NEAR(sigma.dissipation[0], 0.01 * floor, 1e-9 * floor);
    EXPECT_LT(evidence.informative_levels(prediction), 11.0 + 1e-9);
    EXPECT_GT(evidence.informative_levels(prediction), 11.0 - 1e-9);
  }
}

// The likelihood of levels that were repeated is the product of those of the single ones.
TEST(LevelEvidence, LikelihoodIsThatOfEachLevel) {
  const Levels levels = exact_levels();
  Levels all = levels;
  for (std::size_t i = 3; i < 9; ++i) {  // 1.1 D, and 0.9 D of one once more
    all.amplitude.push_back(levels.amplitude[i]);
    all.dissipation.push_back(1.1 * levels.dissipation[i]);
  }
  all.amplitude.push_back(levels.amplitude[4]);
  all.dissipation.push_back(0.9 * levels.dissipation[4]);
  constexpr double kScatter = 0.05;
  double expected = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double mean = dissipation(kJoint, all.amplitude[i]);
    const double sigma = kScatter * mean;
    expected -= 0.5 * std::log(2.0 * std::numbers::pi * sigma * sigma) +
                0.5 * std::pow((all.dissipation[i] - mean) / sigma, 2);
  }
  const LevelEvidence evidence(all);
  EXPECT_EQ(evidence.size(), 12U);
  EXPECT_EQ(evidence.repeat_freedom(), 7.0);
  EXPECT_NEAR(evidence.log_likelihood(of_joint(evidence, kJoint), {kScatter, 1.0}), expected,
              1e-9 * std::abs(expected));
}

// In the order in which they were given, and a single one of two equal ones by √2 more than their
// mean.
TEST(LevelEvidence, DeviationsOfSingleLevels) {
  Levels levels;
  levels.amplitude = {3e-5, 1e-5, 2e-5, 1e-5};
  levels.dissipation = {9.0, 1.0, 3.0, 1.2};
  levels.dissipation_std = {0.1, 0.2, 0.3, 0.2};
  const LevelEvidence evidence(levels);
  const LevelPrediction prediction{.value = {.dissipation = {1.1, 3.0, 9.0}}};
  EXPECT_NEAR(evidence.deviations(prediction).dissipation[0], 0.2 / std::sqrt(2.0), 1e-15);
  const std::vector<double> single = evidence.measured_deviations(prediction).dissipation;
  ASSERT_EQ(single.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(single[i], levels.dissipation_std[i], 1e-15);
}

// Repetitions scatter as the evidence states, and by the common errors all alike. 4000 draws
// determine a deviation to 1.1 % and a mean to 1.6 % of it: five of those.
TEST(LevelEvidence, RepeatedTestsScatterAsTold) {
  Levels levels = exact_levels(true);
  give_deviations(0.02, levels);
  for (const double a : levels.amplitude) levels.linear_dissipation.push_back(2.0 * a * a);
  const LevelEvidence alone(levels);
  const LevelEvidence shared(levels, {.dissipation_gain_std = 0.03, .loss_factor_std = 0.1});
  constexpr int kDraws = 4000;
  constexpr std::size_t kLevel = 7;
  const auto draw = [&](const LevelEvidence& evidence) {
    std::vector<std::vector<double>> columns(3);
    for (int i = 0; i < kDraws; ++i) {
      RandomStream random(11, static_cast<std::uint64_t>(i));
      const Levels again = evidence.simulate(of_joint(evidence, kJoint), {}, random);
      columns[0].push_back(again.dissipation[kLevel] / levels.dissipation[kLevel] - 1.0);
      columns[1].push_back(again.secant_stiffness[kLevel] / levels.secant_stiffness[kLevel] - 1.0);
      columns[2].push_back(again.dissipation[kLevel + 1] / levels.dissipation[kLevel + 1] - 1.0);
    }
    return columns;
  };
  const auto mean_product = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i] / kDraws;
    return sum;
  };
  const auto of_alone = draw(alone);
  EXPECT_NEAR(std::sqrt(mean_product(of_alone[0], of_alone[0])), 0.02, 0.055 * 0.02);
  EXPECT_NEAR(std::sqrt(mean_product(of_alone[1], of_alone[1])), 0.02, 0.055 * 0.02);
  EXPECT_NEAR(mean_product(of_alone[0], of_alone[2]), 0.0, 5.0 * 0.02 * 0.02 / std::sqrt(kDraws));
  const auto of_shared = draw(shared);
  const double loss = 0.1 * levels.linear_dissipation[kLevel] / levels.dissipation[kLevel];
  const double other = 0.1 * levels.linear_dissipation[kLevel + 1] / levels.dissipation[kLevel + 1];
  const double deviation = std::hypot(0.02, 0.03, loss);
  EXPECT_NEAR(std::sqrt(mean_product(of_shared[0], of_shared[0])), deviation, 0.055 * deviation);
  EXPECT_NEAR(mean_product(of_shared[0], of_shared[2]), 0.03 * 0.03 + loss * other,
              5.0 * deviation * deviation / std::sqrt(kDraws));
}

// About 0.674 σ is the median of |z|; twelve levels determine it to a quarter or so, seven draws
// to a tenth: three of these.
TEST(LevelEvidence, ScatterBeforeAnyFit) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, 0);
    Levels levels = exact_levels(true);
    for (double& d : levels.dissipation) d *= 1.0 + 0.02 * random.normal();
    sum += LevelEvidence(levels).expected_scatter(1e5).dissipation / 40.0;
  }
  EXPECT_NEAR(sum, 0.02, 0.004);
  const LevelScatter smooth = LevelEvidence(exact_levels(true)).expected_scatter(1e5);
  EXPECT_GE(smooth.secant_stiffness, 100.0) << "0.1 % of k";
  Levels given = exact_levels(true);
  give_deviations(0.01, given);
  EXPECT_EQ(LevelEvidence(given).expected_scatter(1e5).dissipation, 1.0);
  EXPECT_EQ(LevelEvidence(given).expected_scatter(1e5).secant_stiffness, 1.0);
}

TEST(LevelEvidence, RefusesErrorsThatBreakTheirRules) {
  const auto message = [](const CommonErrors& errors) -> std::string {
    try {
      LevelEvidence(exact_levels(), errors);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message({.amplitude_gain_std = -0.1}),
            "amplitude_gain_std = -0.1; must be a relative standard deviation from 0 to 0.3");
  EXPECT_EQ(message({.dissipation_gain_std = 0.5}),
            "dissipation_gain_std = 0.5; must be a relative standard deviation from 0 to 0.3");
  EXPECT_NE(message({.amplitude_gain_std = std::numeric_limits<double>::quiet_NaN()}), "accepted");
  EXPECT_EQ(message({.loss_factor_std = 0.05}),
            "loss_factor_std = 0.05; needs the linear loss of the levels, linear_dissipation. "
            "A reduction of recordings gives it.");
  EXPECT_THROW(LevelEvidence(Levels{}), InputError);
}

}  // namespace
}  // namespace microslip::level_evidence_test
