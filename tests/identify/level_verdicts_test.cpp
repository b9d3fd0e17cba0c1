// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/level_verdicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"
#include "support/effort.hpp"

namespace microslip::level_verdicts_test {
namespace {

/// Up over so many levels, and down again over the same.
std::vector<double> up_and_down(std::size_t count) {
  std::vector<double> amplitudes = testing::equal_steps(count, 2e-5);
  std::vector<double> down = amplitudes;
  std::ranges::reverse(down);
  amplitudes.insert(amplitudes.end(), down.begin(), down.end());
  return amplitudes;
}

/// Levels of which the falling ones lose more by a share that grows to the top, and are softer by
/// the same share.
Levels sweeps(const Joint& joint, double more, double noise, std::uint64_t draw) {
  Levels levels = testing::levels_at(joint, up_and_down(30));
  testing::add_noise(levels, noise, draw);
  for (std::size_t i = 30; i < 60; ++i) levels.dissipation[i] *= 1.0 + more;
  return levels;
}

const LevelDepartureVerdict* verdict_of(const Identification& found, LevelDeparture departure) {
  const auto at = std::ranges::find(found.verdicts, departure, &LevelDepartureVerdict::departure);
  return at == found.verdicts.end() ? nullptr : &*at;
}

bool warned(const Identification& found, std::string_view code) {
  return std::ranges::find(found.warnings, code, &Warning::code) != found.warnings.end();
}

TEST(LevelVerdicts, SeeThatSweepsUpAndDownDiffer) {
  const Joint joint = testing::reference_joint();
  const Identification found =
      identify(LevelEvidence(sweeps(joint, 0.04, 0.005, 1)), testing::kStiffness);
  const LevelDepartureVerdict* order = verdict_of(found, LevelDeparture::kOrder);
  ASSERT_NE(order, nullptr);
  EXPECT_TRUE(order->broken);
  EXPECT_NEAR(order->share, 0.04, 0.01);
  // The noise of two means of thirty, with that of a slope beside it.
  EXPECT_NEAR(order->noise, 0.005 * std::sqrt(2.0 * 2.0 / 30.0), 1e-3);
  EXPECT_EQ(order->quantity, "D");
  EXPECT_TRUE(warned(found, "order_matters"));
}

TEST(LevelVerdicts, SeeItInTheStiffnessAlone) {
  const Joint joint = testing::reference_joint();
  Levels levels = sweeps(joint, 0.0, 0.005, 2);
  testing::add_secant(joint, 2e-3, 2, levels);
  for (std::size_t i = 30; i < 60; ++i) levels.secant_stiffness[i] *= 0.97;
  const Identification found = identify(LevelEvidence(levels), testing::kStiffness);
  const LevelDepartureVerdict* order = verdict_of(found, LevelDeparture::kOrder);
  ASSERT_NE(order, nullptr);
  EXPECT_TRUE(order->broken);
  EXPECT_EQ(order->quantity, "k_eq");
}

TEST(LevelVerdicts, DoNotJudgeOneSweep) {
  const Joint joint = testing::reference_joint();
  const Identification found =
      identify(LevelEvidence(testing::noisy_levels(joint, 1)), testing::kStiffness);
  EXPECT_EQ(verdict_of(found, LevelDeparture::kOrder), nullptr);
  EXPECT_TRUE(found.verdicts.empty());
}

TEST(LevelVerdicts, NumberWhatIsSaidOfStiffnessAndFrequency) {
  const Joint joint = testing::reference_joint();
  Levels levels = testing::noisy_levels(joint, 3);
  testing::add_secant(joint, 2e-3, 3, levels);
  for (const double a : levels.amplitude) {
    levels.frequency.push_back(60.0 * std::sqrt(secant_stiffness(joint, a) / testing::kStiffness));
  }
  const Identification good = identify(LevelEvidence(levels), testing::kStiffness);
  ASSERT_NE(verdict_of(good, LevelDeparture::kSecant), nullptr);
  EXPECT_FALSE(verdict_of(good, LevelDeparture::kSecant)->broken);
  EXPECT_NEAR(verdict_of(good, LevelDeparture::kSecant)->share, 1.4e-3, 6e-4);
  EXPECT_FALSE(verdict_of(good, LevelDeparture::kFrequency)->broken);

  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels.frequency[i] = 60.0 + 1e4 * levels.amplitude[i];
  }
  const Identification rising = identify(LevelEvidence(levels), testing::kStiffness);
  const LevelDepartureVerdict* frequency = verdict_of(rising, LevelDeparture::kFrequency);
  EXPECT_TRUE(frequency->broken);
  EXPECT_NEAR(frequency->share, 0.05, 0.005);
}

// 300 tables gave none when this was written; 2 % would be too many. In the order of a sweep up and
// down, and in any.
TEST(LevelVerdicts, AreNoneOfGoodLevels) {
  MICROSLIP_OF_RELEASE_ALONE();
  std::vector<testing::NamedJoint> truths = testing::all_truths();
  for (testing::NamedJoint& one : testing::unseen_truths()) truths.push_back(std::move(one));
  constexpr std::uint64_t kTables = 96;
  int wrong = 0;
  for (std::uint64_t i = 0; i < kTables; ++i) {
    const Joint& joint = truths[i % truths.size()].joint;
    RandomStream random(51, i);
    Levels levels = testing::levels_at(joint, up_and_down(20));
    if (i % 2 == 1) {
      for (std::size_t j = levels.size() - 1; j > 0; --j) {
        const auto k = static_cast<std::size_t>(random.uniform() * static_cast<double>(j + 1));
        std::swap(levels.amplitude[j], levels.amplitude[k]);
        std::swap(levels.dissipation[j], levels.dissipation[k]);
      }
    }
    testing::add_noise(levels, std::pow(10.0, -3.0 + 1.5 * random.uniform()), 100 + i);
    testing::add_secant(joint, 2e-3, 100 + i, levels);
    const Identification found = identify(LevelEvidence(levels), testing::kStiffness);
    const bool broken = std::ranges::any_of(
        found.verdicts, [](const LevelDepartureVerdict& one) { return one.broken; });
    wrong += broken ? 1 : 0;
  }
  EXPECT_LE(wrong, 1);
}

}  // namespace
}  // namespace microslip::level_verdicts_test
