// SPDX-License-Identifier: MIT
#include "microslip/io/cells/comment_entry.hpp"

#include <gtest/gtest.h>

#include <string>
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

TEST(CommentEntry, IsToldFromOtherComments) {
  for (const char* entry : {"confidence = 0.95", "p_value[a: b] = 0", "x2 = "}) {
    EXPECT_TRUE(is_comment_entry(entry)) << entry;
  }
  for (const char* other : {"", " = 1", "draws: 40 of seed 1", "microslip identify --k = 1",
                            "warning: few: k = 1", "Key = 1", "key=1", "key[a"}) {
    EXPECT_FALSE(is_comment_entry(other)) << other;
  }
}

}  // namespace
}  // namespace microslip::comment_entry_test
