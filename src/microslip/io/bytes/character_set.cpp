// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/character_set.hpp"

#include <array>
#include <cstddef>

#include "microslip/io/bytes/unicode.hpp"

namespace microslip {
namespace {

/// The characters of the bytes 0x80 to 0x9F; the others are those of Latin-1.
constexpr std::array<char16_t, 32> kCp1252 = {
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

}  // namespace

bool is_utf8(std::string_view text) { return valid_utf8(text) == text.size(); }

std::string to_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::u16string characters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    characters += byte >= 0x80 && byte < 0xA0 ? kCp1252[byte - 0x80U] : char16_t{byte};
  }
  return utf8_of(characters);
}

}  // namespace microslip
