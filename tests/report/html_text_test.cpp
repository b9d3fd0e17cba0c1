// SPDX-License-Identifier: MIT
#include "microslip/report/page/html_text.hpp"

#include <gtest/gtest.h>

namespace microslip::html_text_test {
namespace {

TEST(HtmlText, MarkupBecomesReferences) {
  EXPECT_EQ(html_text("<a href=\"x\">&amp;'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&amp;amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(html_text("µm, Φ0"), "µm, Φ0");
}

TEST(HtmlText, WhatIsNoTextIsReplaced) {
  EXPECT_EQ(html_text("a\nb"), "a b");
  EXPECT_EQ(html_text("\xFFx"), "\xEF\xBF\xBDx");
}

TEST(HtmlId, HasLettersDigitsAndHyphens) {
  EXPECT_EQ(html_id("Stiffness and damping"), "stiffness-and-damping");
  EXPECT_EQ(html_id("</script> \"x\" 2"), "script-x-2");
  EXPECT_EQ(html_id("µ"), "");
}

// The test vectors of RFC 4648, section 10.
TEST(Base64, PublishedVectors) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, AllBits) { EXPECT_EQ(base64("\xFF\xFE\xFD\xFC"), "//79/A=="); }

TEST(SvgAddress, WhatIsNoPlainLetterIsEncoded) {
  EXPECT_EQ(svg_address("<a b=\"#1&2\">µ%</a>"),
            "data:image/svg+xml,%3Ca b=%22%231%262%22%3E%C2%B5%25%3C/a%3E");
}

TEST(SvgAddress, BlanksAndEmptyGroupsAreLeftOut) {
  EXPECT_EQ(svg_address("<g x='1'>\n\t<g y='2'>\n</g>\n<p/></g>"),
            "data:image/svg+xml,%3Cg x='1'%3E %3Cp/%3E%3C/g%3E");
  EXPECT_EQ(svg_address("<g x='1'> <g y='2'> </g></g>"), "data:image/svg+xml,");
  EXPECT_EQ(svg_address("<g>a</g><u/></g>"), "data:image/svg+xml,%3Cg%3Ea%3C/g%3E%3Cu/%3E%3C/g%3E");
}

TEST(BytesOfHex, TwoDigitsAByte) {
  EXPECT_EQ(bytes_of_hex("00ff7A"), std::string("\x00\xFF\x7A", 3));
}

}  // namespace
}  // namespace microslip::html_text_test
