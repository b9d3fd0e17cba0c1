// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/support.hpp"

namespace microslip::uff_fields_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

Numbers numbers_of(std::string_view line, std::vector<std::size_t> widths = {13},
                   bool whole = true) {
  Numbers numbers;
  append_uff_numbers(line, widths, whole, {.file = "t.uff", .line = 7, .column = 0}, numbers);
  return numbers;
}

TEST(UffNumber, TakesWhatFortranWrites) {
  EXPECT_EQ(uff_number(" -3.81956E+00"), -3.81956);
  EXPECT_EQ(uff_number("  1.00000e-02 "), 0.01);
  EXPECT_EQ(uff_number(" 5.00000E-005"), 5e-5);
  EXPECT_EQ(uff_number("  1.00000000000000000D+00"), 1.0);
  EXPECT_EQ(uff_number("2.5d-3"), 0.0025);
  EXPECT_EQ(uff_number("+1.5"), 1.5);
  EXPECT_EQ(uff_number("1.234-105"), 1.234e-105);
  EXPECT_EQ(uff_number("-1.234+105"), -1.234e105);
  EXPECT_EQ(uff_number("12"), 12.0);
  EXPECT_EQ(uff_number(".5E1"), 5.0);
}

TEST(UffNumber, TooSmallIsZeroTooLargeIsNone) {
  EXPECT_EQ(uff_number("1.0E-999"), 0.0);
  EXPECT_EQ(uff_number("4.9406564584124654E-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(uff_number("1.0E+999"), std::nullopt);
}

TEST(UffNumber, RefusesOtherText) {
  for (const char* text : {"", "   ", "abc", "1 2", "1.2.3", "--1", "++1", "+-1", "1E", "1E5E5",
                           "*****", "0x10", "1-", "E5", "-"}) {
    EXPECT_EQ(uff_number(text), std::nullopt) << text;
  }
}

TEST(UffNumbers, WidthsCountNotBlanks) {
  EXPECT_EQ(numbers_of("-1.00000E-105-2.00000E-105  3.00000E+00"),
            (Numbers{-1e-105, -2e-105, 3.0}));
  EXPECT_EQ(numbers_of(" 0.000000E+00 1.234567E-05"), (Numbers{0.0, 1.234567e-5})) << "E13.6";
  EXPECT_EQ(numbers_of("1.234567E-0051.234567E-005"), (Numbers{1.234567e-5, 1.234567e-5}));
  EXPECT_EQ(numbers_of(" 4.07994e-01  5.00000e+00 "), (Numbers{0.407994, 5.0}));
  EXPECT_EQ(numbers_of("  1.00000E+00  2.000000000000E+00", {13, 20}), (Numbers{1.0, 2.0}));
  EXPECT_EQ(numbers_of(std::string("  1.00000E+00") + std::string(67, ' ')), (Numbers{1.0}))
      << "padded to 80 columns";
  EXPECT_TRUE(numbers_of(std::string(80, ' ')).empty());
  EXPECT_TRUE(numbers_of("").empty());
}

TEST(UffNumbers, StandBetweenBlanksWhereTheyDoNotFitTheWidths) {
  EXPECT_EQ(numbers_of("1.0 2.0 3.0"), (Numbers{1.0, 2.0, 3.0}));
  EXPECT_EQ(numbers_of("   1.00000E+00   2.00000E+00"), (Numbers{1.0, 2.0})) << "14 columns";
  EXPECT_EQ(numbers_of(std::string("   1.00000E+00   2.00000E+00") + std::string(52, ' ')),
            (Numbers{1.0, 2.0}))
      << "14 columns, padded to 80";
  EXPECT_EQ(numbers_of("1\t2"), (Numbers{1.0, 2.0}));
}

TEST(UffNumbers, ANumberCutByTheEndOfTheFileDoesNotCount) {
  EXPECT_EQ(numbers_of("  1.00000E+00  2.00000E+0", {13}, false), (Numbers{1.0}));
  EXPECT_EQ(numbers_of("  1.00000E+00  2.00000E+00", {13}, false), (Numbers{1.0, 2.0}));
}

TEST(UffNumbers, NameThePlaceOfOtherText) {
  EXPECT_EQ(message_of<FormatError>([] { return numbers_of("  1.00000E+00        x2.0"); }),
            "t.uff:7:22: expected a number, found 'x2.0'");
}

TEST(UffText, IsUtf8OrElseCp1252) {
  EXPECT_EQ(uff_text("m/s\xB2"), "m/s²");
  EXPECT_EQ(uff_text("m/s\xC2\xB2"), "m/s²");
  EXPECT_EQ(uff_text("\x80 \x99 \xE4"), "€ ™ ä");
  EXPECT_EQ(uff_text("\x81"), "\xEF\xBF\xBD") << "CP1252 has no such character";
  EXPECT_EQ(uff_text(std::string("a\0b\tc", 5)), "a b c");
}

TEST(UffFields, CountCharactersNotBytes) {
  UffFields fields("m/s\xC2\xB2      12", {.file = "t.uff", .line = 3, .column = 0});
  EXPECT_EQ(fields.text(5), "m/s²");
  EXPECT_EQ(fields.integer(8, "n"), 12);
  EXPECT_EQ(fields.integer(8, "n"), 0) << "behind the end of the line";
}

TEST(UffFields, SayWhatIsWrongAndWhere) {
  const auto integer = [](std::string_view text) {
    return message_of<FormatError>([&] {
      UffFields fields(text, {.file = "t.uff", .line = 3, .column = 0});
      fields.skip(2);
      return fields.integer(4, "a node");
    });
  };
  EXPECT_EQ(integer("  1x  "), "t.uff:3:3: expected an integer as a node, found '1x'");
  EXPECT_EQ(integer("  1.5 "), "t.uff:3:3: expected an integer as a node, found '1.5'");
}

TEST(UffText, NoneAndBlankSayNothing) {
  EXPECT_TRUE(uff_is_none("  "));
  EXPECT_TRUE(uff_is_none(" None "));
  EXPECT_FALSE(uff_is_none("NONE1"));
  EXPECT_FALSE(uff_is_none("N"));
}

TEST(UffText, IsPaddedByCharacters) {
  EXPECT_EQ(uff_padded("m/s²", 6), "m/s²  ");
  EXPECT_EQ(uff_padded("²²²²", 2), "²²");
}

}  // namespace
}  // namespace microslip::uff_fields_test
