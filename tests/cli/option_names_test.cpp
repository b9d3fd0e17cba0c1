// SPDX-License-Identifier: MIT
#include "arguments/option_names.hpp"

#include <gtest/gtest.h>

namespace microslip::cli_test::option_names_test {
namespace {

TEST(OptionNames, AreThoseOfTheProgram) {
  EXPECT_EQ(app::with_option_names("Say it by `assume_units force_1=N`, or `out`."),
            "Say it by --assume-units force_1=N, or --out.")
      << "the value stays as it is";
  EXPECT_EQ(app::with_option_names("`smoothing lambda` = 0; must be above 0"),
            "--smoothing lambda = 0; must be above 0");
}

TEST(OptionNames, MayBeThoseOfAnotherCommand) {
  const auto spell = [](std::string_view name, const std::string& option) {
    return name == "rate" ? option + " of convert" : option;
  };
  EXPECT_EQ(app::with_option_names("Give `rate`, or `assume_units a_b=N`.", spell),
            "Give --rate of convert, or --assume-units a_b=N.");
}

TEST(OptionNames, LeaveAllElse) {
  for (const char* text : {"", "`", "``", "no option", "it's `open", "Run `microslip frf --help`.",
                           "levels.csv: channel '`A`' is none", "`1` and `a-b`"}) {
    EXPECT_EQ(app::with_option_names(text), text);
  }
  EXPECT_EQ(app::with_option_names("a ` stray, then `out`"), "a ` stray, then --out");
}

}  // namespace
}  // namespace microslip::cli_test::option_names_test
