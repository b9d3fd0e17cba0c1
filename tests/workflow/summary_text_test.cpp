// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/summary_text.hpp"

#include <gtest/gtest.h>

namespace microslip::summary_text_test {
namespace {

TEST(SummaryText, EachKindOnceWithTheFirstThatHasIt) {
  const std::vector<FlaggedRecord> records = {{"a/one.csv", {{"spike", "s1"}, {"spike", "again"}}},
                                              {"a/two.csv", {{"drift", "d2"}, {"spike", "s2"}}},
                                              {"a/three.csv", {}}};
  const std::vector<Warning> kinds = kinds_of(records, "levels", 30);
  ASSERT_EQ(kinds.size(), 2);
  EXPECT_EQ(kinds[0].code, "spike (2 of 3 levels, first one.csv)");
  EXPECT_EQ(kinds[0].text, "s1");
  EXPECT_EQ(kinds[1].code, "drift (1 of 3 levels, first two.csv)");
}

TEST(SummaryText, LinesBreakBetweenWords) {
  EXPECT_EQ(wrapped("  a: ", "bb cc", 2, 7), "  a: bb\n  cc\n");
  // An option would not be found by its name where a line breaks in it.
  EXPECT_EQ(wrapped("  a: ", "bb `c d` e", 2, 11), "  a: bb\n  `c d` e\n");
  EXPECT_EQ(wrapped("  a: ", "b` c", 2, 7), "  a: b`\n  c\n") << "no pair";
  EXPECT_EQ(shortened("x/abcdef.csv", 6), "~f.csv");
  EXPECT_EQ(counted(1, "level") + ", " + counted(0, "peak"), "1 level, 0 peaks");
}

}  // namespace
}  // namespace microslip::summary_text_test
