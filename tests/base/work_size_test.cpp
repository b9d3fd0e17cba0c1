// SPDX-License-Identifier: MIT
#include "microslip/base/work_size.hpp"

#include <gtest/gtest.h>

#include <string>

#include "microslip/base/error.hpp"

namespace microslip::work_size_test {
namespace {

template <class Check>
std::string message_of(const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// 2^30 bytes in eights.
TEST(WorkSize, KeepsAGibibyte) {
  EXPECT_EQ(most_kept(8.0), std::size_t{1} << 27U);
  EXPECT_NO_THROW(check_memory("`draws`", 134217728.0, 8.0, "Take fewer."));
  EXPECT_EQ(
      message_of([] { check_memory("`draws`", 134217729.0, 8.0, "Take fewer."); }),
      "`draws` = 134217729; must be 134217728 at most: each takes 8 bytes here, and the limit "
      "is 1 GiB. Take fewer.");
}

TEST(WorkSize, EndsAtStepsOfAnHour) {
  EXPECT_NO_THROW(check_steps("steps", 1e10, "", ""));
  EXPECT_EQ(message_of([] { check_steps("steps", 2e10, "2e+06 s in steps of 1e-04 s", "Wait."); }),
            "steps = 20000000000; must be 1e+10 at most, which take an hour or more; these are "
            "2e+06 s in steps of 1e-04 s. Wait.");
}

}  // namespace
}  // namespace microslip::work_size_test
