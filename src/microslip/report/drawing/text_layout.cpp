// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace microslip {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// Advance widths of U+0020 to U+007E in DejaVu Sans, from the font's table `hmtx`, % of the font
// size.
constexpr std::array<unsigned char, 95> kAdvance = {
    32, 40, 46, 84, 64, 95, 78, 27, 39,  39, 50, 84, 32, 36, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 53, 100, 68, 69, 70, 77, 63, 58, 77, 75, 29, 29, 66, 56, 86, 75, 79,
    60, 79, 69, 63, 61, 73, 68, 99, 69,  61, 69, 39, 34, 39, 84, 50, 50, 61, 63, 55, 63, 62, 35, 63,
    63, 28, 28, 58, 28, 97, 63, 61, 63,  63, 41, 52, 39, 63, 59, 82, 59, 59, 52, 64, 34, 64, 84};
constexpr double kOtherAdvance = 70.0;  // Greek letters are 60 to 80, mathematical signs 84
constexpr double kWideAdvance = 100.0;  // from U+2E80 on: scripts that DejaVu does not have
constexpr double kBoldFactor = 1.15;    // DejaVu Sans Bold, mean of the letters

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Bytes of the character that starts with this one; 0 where none does.
std::size_t announced_length(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  if (byte < 0x80U) return 1;
  if (byte >= 0xC2U && byte <= 0xDFU) return 2;
  if (byte >= 0xE0U && byte <= 0xEFU) return 3;
  if (byte >= 0xF0U && byte <= 0xF4U) return 4;
  return 0;
}

std::uint32_t code_point(std::string_view character) {
  if (character.size() == 1) return static_cast<unsigned char>(character[0]);
  std::uint32_t code = static_cast<unsigned char>(character[0]) & (0x7FU >> character.size());
  for (const char byte : character.substr(1)) {
    code = (code << 6U) | (static_cast<unsigned char>(byte) & 0x3FU);
  }
  return code;
}

/// Whether the code is neither an overlong form, nor half of a surrogate pair, nor U+FFFE or
/// U+FFFF, nor beyond Unicode.
bool is_allowed(std::uint32_t code, std::size_t length) {
  if (length == 3) return code >= 0x800U && (code < 0xD800U || code > 0xDFFFU) && code < 0xFFFEU;
  if (length == 4) return code >= 0x10000U && code <= 0x10FFFFU;
  return true;
}

/// The length of the character at the start of the text, 0 where there is none.
std::size_t character_length(std::string_view text) {
  const std::size_t length = announced_length(text[0]);
  if (length == 0 || length > text.size()) return 0;
  const std::string_view character = text.substr(0, length);
  if (!std::all_of(character.begin() + 1, character.end(), is_continuation)) return 0;
  return is_allowed(code_point(character), length) ? length : 0;
}

/// U+0000 to U+001F, and U+007F to U+009F.
bool is_control(std::uint32_t code) { return code < 0x20U || (code >= 0x7FU && code < 0xA0U); }

double advance(std::uint32_t code) {
  if (code >= 0x20U && code < 0x7FU) return kAdvance[code - 0x20U];
  return code >= 0x2E80U ? kWideAdvance : kOtherAdvance;
}

/// The bytes of the longest beginning that fits, one character at least.
std::size_t fitting_length(std::string_view text, double width, Font font) {
  std::size_t length = character_length(text);
  while (length < text.size()) {
    const std::size_t longer = length + character_length(text.substr(length));
    if (text_width(text.substr(0, longer), font) > width) break;
    length = longer;
  }
  return length;
}

/// Takes the next word off the text; what of it does not fit into a line stays for the next one.
std::string next_word(std::string_view& text, double width, Font font) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (text.empty()) return {};
  std::string_view word = text.substr(0, text.find(' '));
  word = word.substr(0, fitting_length(word, width, font));
  text.remove_prefix(word.size());
  return std::string(word);
}

}  // namespace

std::string shown_text(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      shown += kReplacement;
    } else if (is_control(code_point(text.substr(0, length)))) {
      shown += ' ';
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return shown;
}

double text_width(std::string_view text, Font font) {
  const std::string shown = shown_text(text);
  double width = 0.0;
  for (std::string_view rest = shown; !rest.empty();) {
    const std::size_t length = character_length(rest);
    width += advance(code_point(rest.substr(0, length)));
    rest.remove_prefix(length);
  }
  return width / 100.0 * font.size * (font.bold ? kBoldFactor : 1.0);
}

std::vector<std::string> wrapped(std::string_view text, double width, Font font) {
  const std::string shown = shown_text(text);
  std::string_view rest = shown;
  std::vector<std::string> lines;
  std::string line;
  for (std::string word = next_word(rest, width, font); !word.empty();
       word = next_word(rest, width, font)) {
    const std::string longer = line.empty() ? word : fmt::format("{} {}", line, word);
    if (line.empty() || text_width(longer, font) <= width) {
      line = longer;
    } else {
      lines.push_back(std::exchange(line, std::move(word)));
    }
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace microslip
