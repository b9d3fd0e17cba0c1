// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/joint_evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/identify/records/level_agreement.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "support/densities.hpp"
#include "support/effort.hpp"
#include "support/force_records.hpp"
#include "support/messages.hpp"

namespace microslip::joint_evidence_test {
namespace {

using testing::error_of_density;
using testing::kLargestAmplitude;
using testing::kReach;
using testing::kStiffness;

/// A few turns only: one cycle or so at the largest amplitudes.
RecordEvidence short_record(const Joint& joint, std::uint64_t seed = 3) {
  const std::vector<double> path = testing::random_motion(700, kLargestAmplitude, seed);
  return {testing::simulated_record(joint, path, seed), PathStart::kVirgin};
}

LevelEvidence levels_of(const Joint& joint, std::uint64_t draw = 1, double relative = 0.01) {
  Levels levels = testing::levels_at(joint, testing::equal_steps(40));
  testing::add_noise(levels, relative, draw);
  return LevelEvidence(levels);
}

LevelEvidence with_secant(const Joint& joint, std::uint64_t draw = 1) {
  Levels levels = testing::levels_at(joint, testing::equal_steps(40));
  testing::add_noise(levels, 0.01, draw);
  testing::add_secant(joint, 2e-3, draw, levels);
  return LevelEvidence(levels);
}

double width(const Estimate& estimate) { return estimate.upper - estimate.lower; }

/// Of the band of φ, over 5 to 90 % of the range.
double mean_width(const RecordInversionResult& result) {
  const DensityBand band = result.density_band();
  double sum = 0.0;
  int count = 0;
  for (std::size_t j = 0; j < band.lower.size(); ++j) {
    const double share = result.slip_displacement[j] / result.slip_displacement.back();
    if (share < 0.05 || share > 0.9) continue;
    sum += band.upper[j] - band.lower[j];
    ++count;
  }
  return sum / count;
}

std::string codes(const Identification& found) {
  std::string all;
  for (const Warning& warning : found.warnings) all += warning.code + " ";
  return all;
}

const RecordInversionOptions kQuick{.draws = 300};

TEST(JointEvidence, LevelsAndAShortRecordTellMoreThanEither) {
  const Joint joint = testing::reference_joint();
  const RecordEvidence record = short_record(joint);
  const LevelEvidence levels = with_secant(joint);
  const auto alone = invert_records({&record, 1}, {}, kQuick);
  const auto both = invert_together({{&record, 1}, {&levels, 1}, {}, {}}, {}, kQuick);
  EXPECT_TRUE(both.summary.converged()) << both.summary.full();
  EXPECT_FALSE(both.stiffness_known);
  EXPECT_LT(width(both.stiffness), 0.7 * width(alone.stiffness));
  EXPECT_LT(mean_width(both), 0.7 * mean_width(alone));
  EXPECT_NEAR(both.stiffness.value / kStiffness, 1.0, 0.01);
  EXPECT_LT(both.stiffness.lower, kStiffness);
  EXPECT_GT(both.stiffness.upper, kStiffness);
  EXPECT_LE(error_of_density(both.joint(), joint, kReach), 0.06);
}

// D of levels does not depend on k: it comes from the record, and the density from both.
TEST(JointEvidence, FindsKFromTheRecordAlone) {
  const Joint joint = testing::decaying_power_law();
  const RecordEvidence record = short_record(joint);
  const LevelEvidence levels = levels_of(joint);
  const auto alone = invert_records({&record, 1}, {}, kQuick);
  const auto both = invert_together({{&record, 1}, {&levels, 1}, {}, {}}, {}, kQuick);
  EXPECT_NEAR(both.stiffness.value / kStiffness, 1.0, 0.005);
  EXPECT_LT(std::abs(both.stiffness.value - kStiffness),
            std::abs(alone.stiffness.value - kStiffness));
  EXPECT_LT(error_of_density(both.joint(), joint, kReach),
            error_of_density(alone.joint(), joint, kReach));
}

TEST(JointEvidence, TakesSeveralTablesWithAKnownStiffness) {
  const Joint joint = testing::reference_joint();
  const std::vector<LevelEvidence> tables{levels_of(joint, 1, 0.01), levels_of(joint, 2, 0.03),
                                          with_secant(joint, 3)};
  const auto found = invert_together({{}, tables, {}, {}}, kStiffness, kQuick);
  EXPECT_TRUE(found.stiffness_known);
  EXPECT_LE(error_of_density(found.joint(), joint, kReach), 0.08);
  ASSERT_EQ(found.levels.size(), 3U);
  // Each has the scatter that it was given; of 40 levels to a quarter.
  EXPECT_NEAR(found.levels[0].scatter.dissipation, 0.01, 3e-3);
  EXPECT_NEAR(found.levels[1].scatter.dissipation, 0.03, 9e-3);
  EXPECT_NEAR(found.levels[2].scatter.secant_stiffness / kStiffness, 2e-3, 6e-4);
}

TEST(JointEvidence, BelievesTheDeviationsGiven) {
  const Joint joint = testing::reference_joint();
  Levels levels = testing::levels_at(joint, testing::equal_steps(40));
  testing::add_noise(levels, 0.02, 1);
  for (const double d : levels.dissipation) levels.dissipation_std.push_back(0.02 * d);
  const LevelEvidence evidence(levels);
  const RecordEvidence record = short_record(joint);
  const auto found = invert_together({{&record, 1}, {&evidence, 1}, {}, {}}, {}, kQuick);
  EXPECT_FALSE(found.levels.front().scatter_is_relative);
  EXPECT_NEAR(found.levels.front().scatter.dissipation, 1.0, 0.3);
}

TEST(JointEvidence, NamesLevelsOfAnotherJoint) {
  const Joint joint = testing::reference_joint();
  const std::vector<RecordEvidence> records{short_record(joint)};
  const std::vector<LevelEvidence> levels{levels_of(joint), levels_of(testing::two_gaussians())};
  const Identification found =
      identify({records, levels, {"bench.csv"}, {"mine.csv", "other.csv"}}, {}, kQuick);
  const auto warning = std::ranges::find(found.warnings, "levels_contradict", &Warning::code);
  ASSERT_NE(warning, found.warnings.end()) << codes(found);
  EXPECT_EQ(warning->text.find("other.csv"), 0U) << warning->text;
}

TEST(JointEvidence, NamesSecantStiffnessesOfAnotherSetUp) {
  const Joint joint = testing::reference_joint();
  const std::vector<RecordEvidence> records{short_record(joint)};
  Levels levels = with_secant(joint).measured();
  for (double& k : levels.secant_stiffness) k *= 0.95;
  const std::vector<LevelEvidence> softer{LevelEvidence(levels)};
  const Identification found = identify({records, softer, {}, {}}, {}, kQuick);
  EXPECT_NE(codes(found).find("secant_differs"), std::string::npos) << codes(found);
  EXPECT_EQ(codes(found).find("levels_contradict"), std::string::npos) << codes(found);
}

// 48 cases gave none when this was written.
TEST(JointEvidence, FindsNoContradictionAmongGoodEvidence) {
  MICROSLIP_OF_RELEASE_ALONE();
  std::vector<testing::NamedJoint> truths = testing::all_truths();
  for (testing::NamedJoint& one : testing::unseen_truths()) truths.push_back(std::move(one));
  constexpr std::size_t kCases = 24;
  constexpr int kCoefficients = 56;
  for (std::size_t i = 0; i < kCases; ++i) {
    const auto& [name, joint] = truths[i % truths.size()];
    const std::vector<RecordEvidence> records{short_record(joint, 10 + i)};
    const std::vector<LevelEvidence> levels{with_secant(joint, 10 + i)};
    const LevelAgreement found =
        agreement_of_levels({records, levels, {}, {}}, 0, {}, kCoefficients);
    EXPECT_FALSE(found.dissipation->broken)
        << name << ' ' << found.dissipation->share << ' ' << found.dissipation->noise;
    EXPECT_FALSE(found.secant->broken)
        << name << ' ' << found.secant->share << ' ' << found.secant->noise;
  }
}

TEST(JointEvidence, RefusesWhatTellsNoStiffness) {
  const Joint joint = testing::reference_joint();
  const std::vector<LevelEvidence> levels{levels_of(joint), levels_of(joint, 2)};
  test::expect_message(test::message_or("taken",
                                        [&] {
                                          return invert_together({{}, levels, {}, {}}, {}, kQuick);
                                        }),
                       "stiffness");
  test::expect_message(
      test::message_or(
          "taken",
          [&] {
            return invert_together({{}, levels, {}, {}}, kStiffness, {.viscous = true});
          }),
      "viscous");
  test::expect_message(test::message_or("taken", [&] { return invert_together({}); }),
                       "number of records");
}

}  // namespace
}  // namespace microslip::joint_evidence_test
