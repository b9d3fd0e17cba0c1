// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/text_layout.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace microslip::text_layout_test {
namespace {

using Strings = std::vector<std::string>;

TEST(ShownText, KeepsUtf8) { EXPECT_EQ(shown_text("slip φ(f*) µm − 𝛗"), "slip φ(f*) µm − 𝛗"); }

TEST(ShownText, TakesTheLineOutOfControlCharacters) {
  EXPECT_EQ(shown_text(std::string("a\nb\tc\0d\x7F", 8)), "a b c d ");
  EXPECT_EQ(shown_text("a\xC2\x85z"), "a z");  // U+0085, next line
}

TEST(ShownText, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(shown_text("a\xFFz"), "a\uFFFDz");
  EXPECT_EQ(shown_text("\xC3"), "\uFFFD");                      // cut off
  EXPECT_EQ(shown_text("\xC0\xAF"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(shown_text("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // half of a pair
  EXPECT_EQ(shown_text("\xEF\xBF\xBF"), "\uFFFD\uFFFD\uFFFD");  // U+FFFF is not for XML
}

TEST(TextWidth, IsThatOfTheFont) {
  // The font's table: i is 28 % wide, m 97 %.
  EXPECT_NEAR(text_width("im", {.size = 100.0}), 125.0, 1e-9);
  EXPECT_GT(text_width("im", {.size = 100.0, .bold = true}), 125.0);
  EXPECT_EQ(text_width("", {}), 0.0);
}

TEST(Wrapped, BreaksAtBlanks) {
  const Font font{.size = 10.0};
  const double width = text_width("one two", font);
  EXPECT_EQ(wrapped("one two  three", width, font), (Strings{"one two", "three"}));
  EXPECT_EQ(wrapped("  ", width, font), Strings{});
}

TEST(Wrapped, BreaksALongWordAnywhere) {
  const Font font{.size = 10.0};
  const Strings lines = wrapped("φφφφφφφφ", text_width("φφφ", font), font);
  EXPECT_EQ(lines, (Strings{"φφφ", "φφφ", "φφ"}));
  // No room at all still ends, with one character a line.
  EXPECT_EQ(wrapped("ab", -1.0, font), (Strings{"a", "b"}));
}

}  // namespace
}  // namespace microslip::text_layout_test
