// SPDX-License-Identifier: MIT
#include "microslip/io/cells/csv_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::csv_writer_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

TEST(CsvWriter, WritesCommentsHeaderAndRows) {
  CsvWriter writer;
  writer.add_comment("first\nsecond");
  writer.add_numbers("amplitude", kLength, Numbers{1e-6, 0.25});
  writer.add_text("source", Texts{"a,b", "c"});
  writer.add_numbers("share", kDimensionless, Numbers{1, -2});
  EXPECT_EQ(writer.str(),
            "# first\n# second\namplitude [m],source,share [1]\n1e-06,\"a,b\",1\n0.25,c,-2\n");
}

TEST(CsvWriter, RefusesWhatCouldNotBeReadBack) {
  CsvWriter writer;
  EXPECT_EQ(message_of<InputError>([&] { return writer.str(); }),
            "rows = 0; must be 1 or more in a table to be written");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<InputError>([&] {
              return writer.add_numbers("a", kLength, Numbers{1, nan}), 0;
            }),
            "a[1] = nan; must be finite to be written");
  writer.add_numbers("a", kLength, Numbers{1, 2});
  EXPECT_EQ(message_of<InputError>([&] { return writer.add_text("b", Texts{"x"}), 0; }),
            "b = 1 values; must have 2 values like the columns before it");
  EXPECT_EQ(message_of<InputError>([&] {
              return writer.add_text("b [m]", Texts{"x", "y"}), 0;
            }),
            "column name = 'b [m]'; must be text without [ ] , ; \" # and tabs");
}

TEST(CsvWriter, DoesNotDependOnTheLocale) {
  class CommaPunctuation : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    std::string do_grouping() const override { return "\1"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  CsvWriter writer;
  writer.add_numbers("a", kLength, Numbers{12345.5});
  EXPECT_EQ(writer.str(), "a [m]\n12345.5\n");
  std::locale::global(before);
}

/// Any finite double: all exponents, subnormal ones too.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

TEST(CsvWriter, NumbersSurviveTheRoundTrip) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    std::mt19937_64 random(seed);
    Numbers values{0.0, -0.0, 5e-324, -5e-324, 1.7976931348623157e308, 2.2250738585072014e-308};
    while (values.size() < 10000) values.push_back(any_double(random));
    CsvWriter writer;
    writer.add_numbers("a", kLength, values);
    const Numbers back = CsvTable(writer.str(), "").numbers("a", kLength);
    ASSERT_EQ(back.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back[i]), std::bit_cast<std::uint64_t>(values[i]));
    }
  }
}

TEST(CsvWriter, TextsSurviveTheRoundTrip) {
  std::mt19937_64 random(4);
  const std::string alphabet = " \"#,;x1.µ[]-'\xEF\xBB\xBF";
  Texts values{"", "#", " ", "\"", "\"\"", "\xEF\xBB\xBF", "nan", "1", " a "};
  while (values.size() < 5000) {
    std::string text;
    for (std::uint64_t n = random() % 6; n > 0; --n) text += alphabet[random() % alphabet.size()];
    values.push_back(text);
  }
  CsvWriter alone;
  alone.add_text("t", values);
  // Bytes that are no UTF-8 are written as \xNN: tables never have them.
  for (std::string& value : values) value = printable(value);
  EXPECT_EQ(CsvTable(alone.str(), "").text("t"), values);
  CsvWriter among_others;
  among_others.add_text("t", values);
  among_others.add_text("u", values);
  EXPECT_EQ(CsvTable(among_others.str(), "").text("u"), values);
}

TEST(CsvWriter, ControlCharactersBecomeBlanks) {
  CsvWriter writer;
  writer.add_text("t", Texts{std::string("a\nb\0c", 5)});
  EXPECT_EQ(CsvTable(writer.str(), "").text("t"), Texts{"a b c"});
}

TEST(CsvWriter, LeavesCellsEmptyWhereThereIsNoNumber) {
  CsvWriter writer;
  const double none = std::numeric_limits<double>::quiet_NaN();
  writer.add_numbers_or_empty("force", kForce, std::vector<double>{1.5, none});
  writer.add_text("name", std::vector<std::string>{"a", "b"});
  const CsvTable table(writer.str(), "table.csv");
  EXPECT_EQ(table.text("force"), (std::vector<std::string>{"1.5", ""}));
  EXPECT_EQ(table.columns()[0].unit, "N");
  EXPECT_THROW(writer.add_numbers_or_empty("more", kForce, std::vector<double>{1.0}), InputError);
}

}  // namespace
}  // namespace microslip::csv_writer_test
