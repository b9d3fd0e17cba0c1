// SPDX-License-Identifier: MIT
// Warnings of levels by their tests: a wrong test is one finding.
#include "microslip/workflow/campaign/campaign_outliers.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace microslip::campaign_outliers_test {
namespace {

constexpr std::size_t kLevelsOfTest = 12;

CampaignFile two_tests() {
  return {.tests = {{.name = "a", .file = "", .session = "1"},
                    {.name = "b", .file = "", .session = "1"}}};
}

/// D is 1 J in the first test and 1.1 to 1.21 J in the second, and of the joints 1 J.
CampaignLevels levels_of_two() {
  CampaignLevels levels;
  for (std::size_t test = 0; test < 2; ++test) {
    for (std::size_t i = 0; i < kLevelsOfTest; ++i) {
      levels.test.push_back(test);
      levels.levels.amplitude.push_back(1e-5);
      levels.levels.dissipation.push_back(test == 0 ? 1.0 : 1.1 + 0.01 * static_cast<double>(i));
    }
  }
  return levels;
}

Warning outlier(const std::string& test, std::size_t level) {
  return {"level_outlier", test + ": level " + std::to_string(level) + " has much loss."};
}

/// Texts of warnings, of which those of outliers are of these levels.
std::vector<std::string> texts_of(const std::vector<std::size_t>& outliers,
                                  const std::vector<Warning>& warnings) {
  const CampaignLevels levels = levels_of_two();
  std::vector<std::string> texts;
  for (const Warning& warning : with_outliers_by_test(
           two_tests(), levels, std::vector<double>(levels.size(), 1.0), outliers, warnings)) {
    texts.push_back(warning.text);
  }
  return texts;
}

TEST(CampaignOutliers, OfAWholeTestAreOneWarning) {
  std::vector<Warning> warnings{{"scatter_large", "losses scatter."}};
  std::vector<std::size_t> outliers;
  for (std::size_t i = 1; i <= kLevelsOfTest; ++i) {
    warnings.push_back(outlier("b", i));
    outliers.push_back(kLevelsOfTest + i - 1);
  }
  warnings.push_back(outlier("a", 1));
  outliers.push_back(0);
  EXPECT_EQ(
      texts_of(outliers, warnings),
      (std::vector<std::string>{
          "losses scatter.",
          "b: all 12 levels have 1.1 to 1.21 times the identified loss, far outside the scatter "
          "of the levels. They were given full weight: correct the test, or leave it out.",
          "a: level 1 has much loss."}));
}

TEST(CampaignOutliers, AreCountedWithTheirNumbers) {
  const std::vector<std::string> texts = texts_of(
      {13, 15, 22, 23}, {outlier("b", 2), outlier("b", 4), outlier("b", 11), outlier("b", 12)});
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_TRUE(texts[0].starts_with("b: 4 of 12 levels (2, 4, 11, 12) have 1.11 to 1.21 times"))
      << texts[0];
}

TEST(CampaignOutliers, OfAFewLevelsAreNamedEach) {
  const std::vector<Warning> few{outlier("b", 1), outlier("b", 12), outlier("a", 3)};
  EXPECT_EQ(texts_of({12, 23, 2}, few),
            (std::vector<std::string>{few[0].text, few[1].text, few[2].text}));
}

}  // namespace
}  // namespace microslip::campaign_outliers_test
