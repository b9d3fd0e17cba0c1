// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/unicode.hpp"

namespace microslip {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

bool is_high_half(char32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_low_half(char32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

void append_utf8(std::string& text, char32_t c) {
  const auto tail = [&](unsigned shift) {
    text += static_cast<char>(0x80U | ((c >> shift) & 0x3FU));
  };
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xC0U | (c >> 6U));
    tail(0);
  } else if (c < 0x10000) {
    text += static_cast<char>(0xE0U | (c >> 12U));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0U | (c >> 18U));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// Takes the first character off the text; nothing where it is none (RFC 3629).
std::optional<char32_t> take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80   ? 1
                             : byte(0) < 0xC2 ? 0
                             : byte(0) < 0xE0 ? 2
                             : byte(0) < 0xF0 ? 3
                             : byte(0) < 0xF5 ? 4
                                              : 0;
  if (length == 0 || text.size() < length) return std::nullopt;
  char32_t c = length == 1 ? byte(0) : byte(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return std::nullopt;
    c = (c << 6U) | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && c < 0x800) || (length == 4 && c < 0x10000);
  if (overlong || is_high_half(c) || is_low_half(c) || c > 0x10FFFF) return std::nullopt;
  text.remove_prefix(length);
  return c;
}

}  // namespace

std::string utf8_of(std::u16string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char32_t c = text[i];
    if (is_high_half(c) && i + 1 < text.size() && is_low_half(text[i + 1])) {
      c = 0x10000 + ((c - 0xD800) << 10U) + (text[++i] - 0xDC00U);
    } else if (is_high_half(c) || is_low_half(c)) {
      c = kReplacement;
    }
    append_utf8(result, c);
  }
  return result;
}

std::size_t valid_utf8(std::string_view text) {
  std::string_view rest = text;
  while (!rest.empty() && take_character(rest)) {
  }
  return text.size() - rest.size();
}

std::optional<std::u16string> utf16_of(std::string_view text) {
  std::u16string result;
  while (!text.empty()) {
    const std::optional<char32_t> c = take_character(text);
    if (!c) return std::nullopt;
    if (*c < 0x10000) {
      result += static_cast<char16_t>(*c);
    } else {
      result += static_cast<char16_t>(0xD800 + ((*c - 0x10000) >> 10U));
      result += static_cast<char16_t>(0xDC00 + ((*c - 0x10000) & 0x3FFU));
    }
  }
  return result;
}

}  // namespace microslip
