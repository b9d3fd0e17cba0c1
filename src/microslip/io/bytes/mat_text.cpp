// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/mat_text.hpp"

#include <algorithm>

#include "microslip/io/bytes/unicode.hpp"

namespace microslip {

std::vector<std::string> text_rows(std::u16string_view units, std::size_t rows) {
  if (rows <= 1) return {utf8_of(units)};
  std::vector<std::string> texts;
  for (std::size_t row = 0; row < std::min(rows, units.size()); ++row) {
    std::u16string text;
    for (std::size_t i = row; i < units.size(); i += rows) text += units[i];
    text.resize(text.find_last_not_of(std::u16string_view(u" \0", 2)) + 1);
    texts.push_back(utf8_of(text));
  }
  return texts;
}

std::u16string units_of_bytes(std::string_view bytes) {
  if (auto units = utf16_of(bytes)) return *std::move(units);
  std::u16string units;
  for (const char c : bytes) units += static_cast<char16_t>(static_cast<unsigned char>(c));
  return units;
}

bool is_plain_name(std::string_view name) {
  return std::ranges::none_of(name, [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7F;
  });
}

}  // namespace microslip
