// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "microslip/io/bytes/text_pieces.hpp"

namespace microslip::text_test {
namespace {

TEST(Text, QuotesWhatIsPrintable) {
  EXPECT_EQ(in_quotes("amplitude [µm]"), "'amplitude [µm]'");
  EXPECT_EQ(in_quotes(""), "''");
}

TEST(Text, QuotesBytesThatAreNoPrintableUtf8AsHex) {
  EXPECT_EQ(in_quotes(std::string("a\0b\n\x7F", 5)), "'a\\x00b\\x0A\\x7F'");
  EXPECT_EQ(in_quotes("\xB5m"), "'\\xB5m'") << "Latin-1";
  EXPECT_EQ(in_quotes("\xC0\xAF"), "'\\xC0\\xAF'") << "overlong form";
  EXPECT_EQ(in_quotes("\xED\xA0\x80"), "'\\xED\\xA0\\x80'") << "surrogate";
  EXPECT_EQ(in_quotes("\xE2\x82"), "'\\xE2\\x82'") << "cut in mid-character";
  EXPECT_EQ(in_quotes("\xC2\x9B"), "'\\xC2\\x9B'") << "C1 control: terminals obey it";
}

TEST(Text, IsPrintable) {
  EXPECT_EQ(printable("a\x1B[1mµ\n\xB5"), "a\\x1B[1mµ\\x0A\\xB5");
  EXPECT_EQ(printable(""), "");
}

TEST(Text, QuotesTheBeginningOfLongText) {
  EXPECT_EQ(in_quotes(std::string(1000, 'x'), 5), "'xxxxx…' (1000 bytes)");
  EXPECT_EQ(in_quotes("µµµ", 3), "'µµ…' (6 bytes)") << "characters stay whole";
}

TEST(Text, PlacesCountLinesAndCharacters) {
  const TextPlace place = place_at("ab\nµ[x", 6, "file");
  EXPECT_EQ(place.file, "file");
  EXPECT_EQ(place.line, 2U);
  EXPECT_EQ(place.column, 3U);
  EXPECT_EQ(place_at("\xEF\xBB\xBF"
                     "a",
                     3, "")
                .column,
            1U)
      << "the byte order mark is no character";
  EXPECT_EQ(place_at("", 0, "").line, 1U);
}

TEST(Text, OffsetsAreTheInverseOfPlaces) {
  const std::string text =
      "\xEF\xBB\xBF"
      "ab\r\n\nµ[x\n";
  for (const std::size_t offset : {3U, 4U, 5U, 6U, 7U, 8U, 10U, 11U, 12U, 13U}) {
    EXPECT_EQ(offset_of(text, place_at(text, offset, "")), offset);
  }
  EXPECT_EQ(offset_of(text, {"", 9, 1}), text.size());
  EXPECT_EQ(offset_of("", {"", 1, 1}), 0U);
}

TEST(Text, ShowsWhatIsFoundAtAnOffset) {
  EXPECT_EQ(found_at("a = b c\r\nd", 4), "'b c'");
  EXPECT_EQ(found_at("a = \nd", 4), "the end of the line");
  EXPECT_EQ(found_at("a = ", 4), "the end of the file");
  EXPECT_EQ(found_at(std::string(100, 'x'), 0), "'xxxxxxxxxxxxxxxxxxxx'");
}

TEST(Text, TrimsBlanksAndTabs) {
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t "), "");
}

TEST(Text, ListsTheFirstOfMany) {
  const std::vector<std::string> names{"a", "b", "c"};
  EXPECT_EQ(first_texts(names, 3), "a, b, c");
  EXPECT_EQ(first_texts(names, 2), "a, b, and 1 more");
  EXPECT_EQ(first_texts(names, 1, "; "), "a; and 2 more");
  EXPECT_EQ(list_of_names(names, 2), "'a', 'b', and 1 more");
  EXPECT_EQ(list_of_names({}), "nothing");
}

TEST(TextPieces, AreLinesCellsAndWholeNumbers) {
  std::string_view rest = "a\r\n\nb";
  EXPECT_EQ(take_line(rest), "a\r");
  EXPECT_EQ(take_line(rest), "");
  EXPECT_EQ(rest, "b");
  EXPECT_EQ(take_dos_line(rest), "b");
  EXPECT_EQ(take_line(rest), "");
  rest = "a\r\nb";
  EXPECT_EQ(take_dos_line(rest), "a");
  using Cells = std::vector<std::string_view>;
  EXPECT_EQ(comma_cells(" a, b\t,,"), (Cells{"a", "b", "", ""}));
  EXPECT_EQ(comma_cells(""), Cells{""});
  EXPECT_EQ(whole_integer("-12"), -12);
  for (const char* text : {"", " 1", "+1", "1 ", "1.0", "9223372036854775808"}) {
    EXPECT_FALSE(whole_integer(text)) << text;
  }
  EXPECT_EQ(whole_number<double>("1.5e3"), 1500.0);
}

}  // namespace
}  // namespace microslip::text_test
