// SPDX-License-Identifier: MIT
#include "microslip/io/output/provenance.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace microslip::provenance_test {
namespace {

TEST(InputHashes, AreReadAsTheyAreWritten) {
  const std::vector<std::string> comments{
      "microslip 0.1.0: microslip verify a: sha256", hash_comment("a = b: sha256 c.csv", "12ab"),
      "3 recordings: sha256sum | sha256sum 34cd", hash_comment("microslip x.mat", "56ef")};
  EXPECT_EQ(comments[3], "sha256[microslip x.mat] = 56ef");
  const std::vector<InputHash> expected{{"a = b: sha256 c.csv", "12ab"},
                                        {"microslip x.mat", "56ef"}};
  EXPECT_EQ(hashes_in(comments), expected);
}

// As files of earlier versions have them.
TEST(InputHashes, AreReadBehindTheirFile) {
  const std::vector<std::string> comments{"microslip 0.1.0: microslip reduce",
                                          "rig.toml: sha256 12ab", "a: b.csv: sha256 34cd"};
  const std::vector<InputHash> expected{{"rig.toml", "12ab"}, {"a: b.csv", "34cd"}};
  EXPECT_EQ(hashes_in(comments), expected);
}

}  // namespace
}  // namespace microslip::provenance_test
