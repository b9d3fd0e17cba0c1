// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/distinct_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "support/messages.hpp"

namespace microslip::distinct_files_test {
namespace {

// A variable of a MATLAB file holds its elements and fields: both together would count them twice.
TEST(DistinctFiles, APartIsInItsWhole) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("f.mat");
  test::put(file, "x");
  const auto same = [&](const std::string& a, const std::string& b) {
    const std::vector<std::string> before{file + a};
    return same_file(before, file + b).has_value();
  };
  EXPECT_TRUE(same(":X", ":X(2)"));
  EXPECT_TRUE(same(":X(2)", ":X"));
  EXPECT_TRUE(same(":X", ":X.force"));
  EXPECT_TRUE(same("", ":X"));
  EXPECT_TRUE(same(":X(2)", ":X[1]"));  // from 0 in square brackets
  EXPECT_TRUE(same(":X(2)", ":X{2}.a"));
  EXPECT_FALSE(same(":X(1)", ":X(2)"));
  EXPECT_FALSE(same(":X(1)", ":X(12)"));
  EXPECT_FALSE(same(":X", ":X2"));
  EXPECT_FALSE(same(":X(", ":X(a)"));
}

TEST(DistinctFiles, LinksAreTheirFiles) {
  const test::TemporaryFolder folder;
  test::put(folder.file("a.csv"), "x");
  test::put(folder.file("copy.csv"), "x");
  std::filesystem::create_symlink(folder.file("a.csv"), folder.file("link.csv"));
  const std::vector<std::string> linked{folder.file("a.csv"), folder.file("link.csv")};
  test::expect_message(test::message_or<InputError>("none",
                                                    [&] {
                                                      check_distinct_files(linked);
                                                      return 0;
                                                    }),
                       "counts twice");
  const std::vector<std::string> copied{folder.file("a.csv"), folder.file("copy.csv")};
  EXPECT_NO_THROW(check_distinct_files(copied));
}

}  // namespace
}  // namespace microslip::distinct_files_test
