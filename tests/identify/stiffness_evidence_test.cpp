// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/stiffness_evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/secant.hpp"
#include "support/densities.hpp"

namespace microslip::stiffness_evidence_test {
namespace {

using testing::kStiffness;

bool has(const std::vector<Warning>& warnings, std::string_view code) {
  return std::ranges::find(warnings, code, &Warning::code) != warnings.end();
}

std::string text_of(const std::vector<Warning>& warnings, std::string_view code) {
  const auto found = std::ranges::find(warnings, code, &Warning::code);
  return found == warnings.end() ? std::string() : found->text;
}

std::vector<Warning> warnings_of(const Levels& levels, const Joint& joint) {
  return diagnose(stiffness_evidence(levels, joint), joint);
}

/// Levels of the reference joint in a mode of 80 Hz when stuck, of whose stiffness a share is the
/// joint's at first: f² = f0² (1 − p + p k_eq/k).
Levels levels_with_frequency(double share) {
  Levels levels = testing::exact_levels(testing::reference_joint());
  for (const double a : levels.amplitude) {
    const double k = secant_stiffness(testing::reference_joint(), a) / kStiffness;
    levels.frequency.push_back(80.0 * std::sqrt(1.0 - share + share * k));
  }
  return levels;
}

TEST(StiffnessEvidence, IsNothingWhereNothingWasMeasured) {
  const StiffnessEvidence none = stiffness_evidence(
      testing::exact_levels(testing::reference_joint()), testing::reference_joint());
  EXPECT_FALSE(none.secant.has_value());
  EXPECT_FALSE(none.frequency.has_value());
  EXPECT_TRUE(diagnose(none, testing::reference_joint()).empty());
}

// Whatever the share of the joint in the stiffness of the mode, exact frequencies give no warning;
// where it is all of it, f² ∝ k_eq leaves nothing but rounding. The share itself changes with
// k_eq for 0 < p < 1, so that the remainder is of second order: below a tenth of the softening.
TEST(StiffnessEvidence, FrequenciesOfTheJointAreExplained) {
  for (const double share : {0.0, 0.05, 0.3, 1.0}) {
    const Levels levels = levels_with_frequency(share);
    const StiffnessEvidence found = stiffness_evidence(levels, testing::reference_joint());
    EXPECT_TRUE(diagnose(found, testing::reference_joint()).empty()) << share;
    ASSERT_TRUE(found.frequency.has_value());
    const double softening = levels.frequency.front() - levels.frequency.back();
    EXPECT_LE(found.frequency->uncertainty, 0.1 * softening + 1e-9) << share;
    EXPECT_GE(found.frequency->share, 0.0);
    EXPECT_LE(found.frequency->share, 1.0);
    if (share == 1.0) {
      EXPECT_NEAR(found.frequency->share, 1.0, 1e-6);
      EXPECT_LT(found.frequency->equivalent_joint_error, 1e-9);
    }
  }
}

TEST(StiffnessEvidence, ARisingFrequencyIsToldWithItsNumbers) {
  Levels levels = testing::exact_levels(testing::reference_joint());
  levels.frequency.assign(levels.size(), 80.0);
  EXPECT_TRUE(warnings_of(levels, testing::reference_joint()).empty());
  levels.frequency.back() = 80.2;  // as a drive in steps may
  EXPECT_TRUE(warnings_of(levels, testing::reference_joint()).empty());
  levels.frequency.back() = 80.4;
  const std::vector<Warning> warnings = warnings_of(levels, testing::reference_joint());
  ASSERT_TRUE(has(warnings, "frequency_rises"));
  const std::string text = text_of(warnings, "frequency_rises");
  EXPECT_NE(text.find("rises by 0.50 %"), std::string::npos) << text;
  EXPECT_NE(text.find("(80 to 80.4 Hz)"), std::string::npos) << text;
  EXPECT_NE(text.find("at least ± 0.2 Hz"), std::string::npos) << text;
  // The order of the rows does not matter.
  std::ranges::reverse(levels.amplitude);
  std::ranges::reverse(levels.dissipation);
  std::ranges::reverse(levels.frequency);
  EXPECT_EQ(text_of(warnings_of(levels, testing::reference_joint()), "frequency_rises"), text);
}

// With deviations smaller steps count, larger ones do not where they are within them.
TEST(StiffnessEvidence, DeviationsDecideWhereTheyAreGiven) {
  Levels levels = testing::exact_levels(testing::reference_joint());
  levels.frequency.assign(levels.size(), 80.0);
  levels.frequency.back() = 80.16;  // 0.2 %
  levels.frequency_std.assign(levels.size(), 0.005);
  EXPECT_TRUE(has(warnings_of(levels, testing::reference_joint()), "frequency_rises"));
  levels.frequency.back() = 80.4;
  levels.frequency_std.assign(levels.size(), 0.1);
  EXPECT_FALSE(has(warnings_of(levels, testing::reference_joint()), "frequency_rises"));
}

// Scatter of the given size, 200 sets of 90 levels: no false alarm in 100.
TEST(StiffnessEvidence, ScatterOfTheSizeToldIsNoAlarm) {
  int alarms = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(7, seed);
    Levels levels = levels_with_frequency(0.3);
    for (double& f : levels.frequency) f += 0.2 * random.normal();
    levels.frequency_std.assign(levels.size(), 0.2);
    alarms += warnings_of(levels, testing::reference_joint()).empty() ? 0 : 1;
  }
  EXPECT_LE(alarms, 2);
}

// A mode that softens twice as much as the joint could soften it, even if it provided all of the
// stiffness.
TEST(StiffnessEvidence, SofteningBeyondTheJointIsTold) {
  Levels levels = levels_with_frequency(1.0);
  for (double& f : levels.frequency) f = 80.0 - 2.0 * (80.0 - f);
  const std::vector<Warning> warnings = warnings_of(levels, testing::reference_joint());
  ASSERT_TRUE(has(warnings, "softening_unexplained"));
  EXPECT_FALSE(has(warnings, "frequency_rises"));
  EXPECT_NE(text_of(warnings, "softening_unexplained").find("explains"), std::string::npos);
}

// Two sessions, the second 0.6 % higher all over: neighbouring frequencies show it.
TEST(StiffnessEvidence, SessionsAreToldApart) {
  Levels levels = levels_with_frequency(0.02);
  for (std::size_t i = 1; i < levels.size(); i += 2) levels.frequency[i] *= 1.006;
  EXPECT_TRUE(has(warnings_of(levels, testing::reference_joint()), "frequency_rises"));
  const auto found = stiffness_evidence(levels, testing::reference_joint()).frequency;
  EXPECT_NEAR(found->uncertainty, 0.5 * 0.006 * 80.0, 0.05);
}

// k_eq 26 % of k below the joint's: much slips below the lowest level, where D determines only two
// moments, and the elastic remainder is doubtful.
TEST(StiffnessEvidence, AMeasuredStiffnessQuestionsTheRemainder) {
  const Joint joint(kStiffness, SlipDensity({UniformPart{0.0, 40.0, 0.5}}));
  Levels levels = testing::exact_levels(joint);
  for (const double a : levels.amplitude) {
    levels.secant_stiffness.push_back(secant_stiffness(joint, a));
    levels.secant_stiffness_std.push_back(0.005 * kStiffness);
  }
  EXPECT_TRUE(warnings_of(levels, joint).empty());
  for (double& k : levels.secant_stiffness) k -= 0.26 * kStiffness;
  const std::vector<Warning> warnings = warnings_of(levels, joint);
  const std::string text = text_of(warnings, "secant_inconsistent");
  EXPECT_NE(text.find("26.0 % of k"), std::string::npos) << text;
  EXPECT_NE(text.find("the elastic remainder is then 24.0 %, not 50.0 %"), std::string::npos)
      << text;
  EXPECT_FALSE(has(warnings, "secant_misfit"));
  levels.secant_stiffness_std.assign(levels.size(), 0.1 * kStiffness);
  EXPECT_TRUE(warnings_of(levels, joint).empty()) << "within three of its deviations";
}

// k_eq that falls by a tenth of k more than the joint's does.
TEST(StiffnessEvidence, AnotherChangeOverTheAmplitudeIsTold) {
  const Joint joint = testing::reference_joint();
  Levels levels = testing::exact_levels(joint);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(levels.size() - 1);
    levels.secant_stiffness.push_back(secant_stiffness(joint, levels.amplitude[i]) -
                                      0.1 * kStiffness * (share - 0.5));
    levels.secant_stiffness_std.push_back(0.005 * kStiffness);
  }
  const std::vector<Warning> warnings = warnings_of(levels, joint);
  EXPECT_TRUE(has(warnings, "secant_misfit"));
  const SecantEvidence secant = *stiffness_evidence(levels, joint).secant;
  // A uniform spread of 0.1 k has an rms of 0.1 k/√12.
  EXPECT_NEAR(*secant.scatter, 0.1 / std::sqrt(12.0) / 0.005, 0.2);
  EXPECT_NEAR(secant.offset / kStiffness, 0.0, 1e-3);
}

TEST(StiffnessEvidence, RefusesFrequenciesThatAreNone) {
  Levels levels = levels_with_frequency(0.3);
  levels.frequency[3] = 0.0;
  EXPECT_THROW((void)stiffness_evidence(levels, testing::reference_joint()), InputError);
  levels.frequency[3] = 80.0;
  levels.frequency_std.assign(2, 0.1);
  EXPECT_THROW((void)stiffness_evidence(levels, testing::reference_joint()), InputError);
}

}  // namespace
}  // namespace microslip::stiffness_evidence_test
