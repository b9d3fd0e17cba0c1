// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/mat_text.hpp"

#include <algorithm>

#include "microslip/io/bytes/unicode.hpp"

namespace microslip {
namespace {

/// Each row of characters that are stored column by column, without blanks and zeros at its end.
template <class Character>
std::vector<std::basic_string<Character>> rows_of(std::basic_string_view<Character> characters,
                                                  std::size_t rows) {
  constexpr Character kPadding[] = {' ', 0};
  std::vector<std::basic_string<Character>> texts;
  for (std::size_t row = 0; row < std::min(rows, characters.size()); ++row) {
    std::basic_string<Character>& text = texts.emplace_back();
    for (std::size_t i = row; i < characters.size(); i += rows) text += characters[i];
    text.resize(text.find_last_not_of(std::basic_string_view<Character>(kPadding, 2)) + 1);
  }
  return texts;
}

}  // namespace

std::vector<std::string> text_rows(std::u16string_view units, std::size_t rows) {
  if (rows <= 1) return {utf8_of(units)};
  std::vector<std::string> texts;
  for (const std::u16string& row : rows_of(units, rows)) texts.push_back(utf8_of(row));
  return texts;
}

std::vector<std::string> text_rows_of_bytes(std::string_view bytes, std::size_t rows) {
  if (rows <= 1) return {utf8_of(units_of_bytes(bytes))};
  std::vector<std::string> texts;
  for (const std::string& row : rows_of(bytes, rows)) {
    texts.push_back(utf8_of(units_of_bytes(row)));
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
