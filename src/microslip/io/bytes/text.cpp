// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>

namespace microslip {
namespace {

/// Characters that turn the direction of a text, or end a line of it, and show nothing: U+061C,
/// U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069.
bool turns_text(std::string_view character) {
  if (character == "\xD8\x9C") return true;
  if (character.size() != 3 || !character.starts_with('\xE2')) return false;
  const auto second = static_cast<unsigned char>(character[1]);
  const auto third = static_cast<unsigned char>(character[2]);
  return (second == 0x80 && (third == 0x8E || third == 0x8F || (third >= 0xA8 && third <= 0xAE))) ||
         (second == 0x81 && third >= 0xA6 && third <= 0xA9);
}

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// Moves the first character of a text, not empty, to the result as printable() has it.
void move_printable(std::string& result, std::string_view& rest) {
  const std::size_t length = printable_length(rest);
  if (length > 0) {
    result += rest.substr(0, length);
  } else {
    result += fmt::format("\\x{:02X}", static_cast<unsigned char>(rest.front()));
  }
  rest.remove_prefix(std::max<std::size_t>(length, 1));
}

}  // namespace

std::size_t printable_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < length) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  // C1 controls, overlong forms, surrogates and what lies beyond U+10FFFF.
  if ((first == 0xC2 && second < 0xA0) || (first == 0xE0 && second < 0xA0) ||
      (first == 0xED && second > 0x9F) || (first == 0xF0 && second < 0x90) ||
      (first == 0xF4 && second > 0x8F)) {
    return 0;
  }
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  const bool whole =
      std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), continues);
  return whole && !turns_text(text.substr(0, length)) ? length : 0;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) move_printable(result, text);
  return result;
}

std::string in_quotes(std::string_view text, std::size_t limit) {
  std::string result = "'";
  std::string_view rest = text;
  while (!rest.empty() && text.size() - rest.size() < limit) move_printable(result, rest);
  result += rest.empty() ? "'" : fmt::format("…' ({} bytes)", text.size());
  return result;
}

TextPlace place_at(std::string_view text, std::size_t offset, std::string_view file) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_break = before.rfind('\n');
  std::string_view line = before.substr(line_break == std::string_view::npos ? 0 : line_break + 1);
  if (line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  return {.file = std::string(file),
          .line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
          .column = 1 + static_cast<std::size_t>(
                            std::count_if(line.begin(), line.end(), starts_character))};
}

std::size_t offset_of(std::string_view text, const TextPlace& place) {
  std::size_t offset = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  for (std::size_t line = 1; line < place.line; ++line) {
    const std::size_t line_break = text.find('\n', offset);
    if (line_break == std::string_view::npos) return text.size();
    offset = line_break + 1;
  }
  std::size_t column = 0;
  for (; offset < text.size(); ++offset) {
    if (starts_character(text[offset]) && ++column >= place.column) break;
  }
  return offset;
}

std::string found_at(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return "the end of the file";
  const std::string_view rest = text.substr(offset);
  const std::size_t length = std::min<std::size_t>(rest.find_first_of("\r\n"), 20);
  return length == 0 ? "the end of the line" : in_quotes(rest.substr(0, length));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string first_texts(const std::vector<std::string>& texts, std::size_t most,
                        std::string_view separator) {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(texts.size(), most));
  std::string text = fmt::format("{}", fmt::join(texts.begin(), texts.begin() + shown, separator));
  if (texts.size() > most) text += fmt::format("{}and {} more", separator, texts.size() - most);
  return text;
}

std::string list_of_names(const std::vector<std::string>& names, std::size_t most) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(in_quotes(name));
  return names.empty() ? "nothing" : first_texts(quoted, most);
}

std::string in_capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

}  // namespace microslip
