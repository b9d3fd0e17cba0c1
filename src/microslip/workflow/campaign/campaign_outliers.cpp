// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_outliers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace microslip {
namespace {

constexpr const char* kOutlier = "level_outlier";
constexpr std::size_t kMostByThemselves = 3;

/// The outliers of a test.
struct OutliersOfTest {
  std::vector<std::size_t> number = {};                       ///< of each in the test, from 1
  double least = std::numeric_limits<double>::quiet_NaN();    ///< D over that of the joints, 1
  double largest = std::numeric_limits<double>::quiet_NaN();  ///< as above
};

std::string outliers_text(const std::string& test, std::size_t levels,
                          const OutliersOfTest& outliers) {
  const std::size_t count = outliers.number.size();
  std::string text = count == levels ? fmt::format("{}: all {} levels", test, levels)
                                     : fmt::format("{}: {} of {} levels ({})", test, count, levels,
                                                   fmt::join(outliers.number, ", "));
  if (std::isfinite(outliers.least)) {
    text += fmt::format(" have {:.3g} to {:.3g} times the identified loss,", outliers.least,
                        outliers.largest);
  } else {
    text += " are";
  }
  return text +
         " far outside the scatter of the levels. They were given full weight: correct the test, "
         "or leave it out.";
}

/// Those of tests that have many, by test.
std::map<std::size_t, OutliersOfTest> many_outliers(const CampaignLevels& levels,
                                                    const std::vector<double>& dissipation,
                                                    const std::vector<std::size_t>& outliers) {
  std::map<std::size_t, OutliersOfTest> tests;
  for (const std::size_t level : outliers) {
    const auto first = std::ranges::find(levels.test, levels.test[level]) - levels.test.begin();
    const double over = levels.levels.dissipation[level] / dissipation[level];
    OutliersOfTest& test = tests[levels.test[level]];
    test.number.push_back(level - static_cast<std::size_t>(first) + 1);
    test.least = std::fmin(test.least, over);
    test.largest = std::fmax(test.largest, over);
  }
  std::erase_if(tests,
                [](const auto& one) { return one.second.number.size() <= kMostByThemselves; });
  return tests;
}

}  // namespace

std::vector<Warning> with_outliers_by_test(const CampaignFile& plan, const CampaignLevels& levels,
                                           const std::vector<double>& dissipation,
                                           const std::vector<std::size_t>& outliers,
                                           std::vector<Warning> warnings) {
  std::map<std::size_t, OutliersOfTest> many = many_outliers(levels, dissipation, outliers);
  std::vector<Warning> gathered;
  auto level = outliers.begin();
  for (Warning& warning : warnings) {
    const bool is_outlier = warning.code == kOutlier && level != outliers.end();
    const auto test = is_outlier ? many.find(levels.test[*level++]) : many.end();
    if (test == many.end()) {
      gathered.push_back(std::move(warning));
    } else if (!test->second.number.empty()) {
      const auto all = static_cast<std::size_t>(std::ranges::count(levels.test, test->first));
      gathered.push_back(
          {kOutlier, outliers_text(plan.tests[test->first].name, all, test->second)});
      test->second.number.clear();
    }
  }
  return gathered;
}

}  // namespace microslip
