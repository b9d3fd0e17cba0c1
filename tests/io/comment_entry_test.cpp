// SPDX-License-Identifier: MIT
#include "microslip/io/cells/comment_entry.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

namespace microslip::comment_entry_test {
namespace {

TEST(CommentEntry, IsFoundByKeyAndSubject) {
  const std::vector<std::string> comments{
      "microslip 0.1.0: microslip verify --x = 1", comment_entry("confidence", "", "0.95"),
      comment_entry("p_value", "a.mat:X(1) ] = b: force", "0.1"),
      comment_entry("p_value", "a.mat:X(1)", "0.25"), comment_entry("trend", "torque", "D\n+1 %")};
  EXPECT_EQ(comments[1], "confidence = 0.95");
  EXPECT_EQ(comments[3], "p_value[a.mat:X(1)] = 0.25");
  EXPECT_EQ(find_number_entry(comments, "confidence"), 0.95);
  EXPECT_EQ(find_number_entry(comments, "p_value", "a.mat:X(1) ] = b: force"), 0.1);
  EXPECT_EQ(find_number_entry(comments, "p_value", "a.mat:X(1)"), 0.25);
  EXPECT_EQ(find_entry(comments, "trend", "torque"), "D +1 %") << "on one line";
  EXPECT_FALSE(find_number_entry(comments, "trend", "torque")) << "no number";
  const std::vector<std::string> named{"confidence = 0.5: sha256 ab", comments[1]};
  EXPECT_EQ(find_number_entry(named, "confidence"), 0.95) << "not the file of that name";
  EXPECT_FALSE(find_entry(comments, "p_value"));
  EXPECT_FALSE(find_entry(comments, "value"));
}

TEST(CommentEntry, HasKeySubjectAndValue) {
  for (const auto& [text, key, subject, value] :
       {std::tuple{"confidence = 0.95", "confidence", "", "0.95"},
        std::tuple{"p_value[a: b] = 0", "p_value", "a: b", "0"},
        std::tuple{"note[microslip x.mat] = phase: a = b", "note", "microslip x.mat",
                   "phase: a = b"},
        std::tuple{"x2 = ", "x2", "", ""}}) {
    const auto entry = parse_comment_entry(text);
    ASSERT_TRUE(entry) << text;
    EXPECT_EQ(entry->key, key);
    EXPECT_EQ(entry->subject, subject);
    EXPECT_EQ(entry->value, value);
  }
  for (const char* other : {"", " = 1", "draws: 40 of seed 1", "microslip identify --k = 1",
                            "warning: few: k = 1", "Key = 1", "key=1", "key[a", "key(a] = 1"}) {
    EXPECT_FALSE(parse_comment_entry(other)) << other;
  }
}

}  // namespace
}  // namespace microslip::comment_entry_test
