// SPDX-License-Identifier: MIT
#include "microslip/base/gather.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace microslip::gather_test {
namespace {

TEST(Gather, TakesValuesInTheOrderOfTheirPlaces) {
  const std::vector<std::string> values{"a", "b", "c"};
  const std::vector<std::size_t> which{2, 0, 2};
  EXPECT_EQ(gather(values, which), (std::vector<std::string>{"c", "a", "c"}));
}

TEST(Gather, TakesNothingOfAColumnThatIsNotThere) {
  EXPECT_TRUE(gather(std::vector<double>{}, std::vector<std::size_t>{2, 0}).empty());
}

TEST(Gather, TakesNothingOfNoPlaces) { EXPECT_TRUE(gather(std::vector<double>{1.0}, {}).empty()); }

}  // namespace
}  // namespace microslip::gather_test
