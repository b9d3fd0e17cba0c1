// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/character_set.hpp"

#include <gtest/gtest.h>

#include <string>

namespace microslip::character_set_test {
namespace {

TEST(CharacterSet, LeavesUtf8AsItIs) {
  for (const char* text : {"", "plain", "m/s²", "µm", "−", "😀", "\xEF\xBF\xBD"}) {
    EXPECT_EQ(to_utf8(text), text);
  }
}

TEST(CharacterSet, TakesOtherTextAsCp1252) {
  EXPECT_EQ(to_utf8("m/s\xB2"), "m/s²");
  EXPECT_EQ(to_utf8("\xB5m"), "µm");
  EXPECT_EQ(to_utf8("\x80 \x96 \x9F"), "€ – Ÿ") << "where CP1252 differs from Latin-1";
  EXPECT_EQ(to_utf8("\x81"), "\xEF\xBF\xBD") << "a byte without meaning";
  EXPECT_EQ(to_utf8("B\xF6hm"), "Böhm");
}

TEST(CharacterSet, WhatOnlyLooksLikeUtf8IsNone) {
  EXPECT_EQ(to_utf8("\xC0\x80"), "À€") << "an overlong form";
  EXPECT_EQ(to_utf8("\xED\xA0\x80"), "í\xC2\xA0€") << "a surrogate";
  EXPECT_EQ(to_utf8("\xE2\x82"), "â‚") << "cut short";
  EXPECT_EQ(to_utf8("\xF5"), "õ");
}

}  // namespace
}  // namespace microslip::character_set_test
