// SPDX-License-Identifier: MIT
#include "microslip/report/page/html_text.hpp"

#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>

#include "microslip/report/drawing/text_layout.hpp"

namespace microslip {

std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : shown_text(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string html_id(std::string_view text) {
  std::string id;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U && std::isalnum(byte) != 0) {
      id += static_cast<char>(std::tolower(byte));
    } else if (!id.empty() && id.back() != '-') {
      id += '-';
    }
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto byte =
          i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : std::uint32_t{0};
      group = (group << 8U) | byte;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const std::uint32_t digit = (group >> (18U - 6U * static_cast<unsigned>(j))) & 63U;
      text += i + j <= bytes.size() ? kDigits[digit] : '=';
    }
  }
  return text;
}

namespace {

/// The picture without runs of blanks and line breaks longer than one, and without empty groups, of
/// which gnuplot leaves many.
std::string slim_svg(std::string_view svg) {
  constexpr std::string_view kBlanks = " \t\r\n";
  constexpr std::string_view kEnd = "</g>";
  std::string slim;
  for (std::size_t i = 0; i < svg.size(); ++i) {
    if (kBlanks.find(svg[i]) != std::string_view::npos) {
      if (!slim.empty() && slim.back() != ' ') slim += ' ';
      continue;
    }
    slim += svg[i];
    if (!slim.ends_with(kEnd)) continue;
    const std::string_view before = std::string_view(slim).substr(0, slim.size() - kEnd.size());
    const std::size_t tag = before.rfind('<');
    if (tag == std::string_view::npos || !before.substr(tag).starts_with("<g ")) continue;
    const std::size_t close = before.find('>', tag);
    const bool empty = before.find_first_not_of(kBlanks, close + 1) == std::string_view::npos;
    if (empty && before[close - 1] != '/') slim.resize(tag);
  }
  return slim;
}

}  // namespace

std::string svg_address(std::string_view svg) {
  constexpr std::string_view kAsTheyAre = " -._~!$()*,;=:@/?'";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string address = "data:image/svg+xml,";
  for (const char c : slim_svg(svg)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        byte < 0x80U && (std::isalnum(byte) != 0 || kAsTheyAre.find(c) != std::string_view::npos);
    if (plain) {
      address += c;
    } else {
      address += '%';
      address += kDigits[byte >> 4U];
      address += kDigits[byte & 15U];
    }
  }
  return address;
}

std::string bytes_of_hex(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    unsigned value = 0;
    std::from_chars(digits.data() + i, digits.data() + i + 2, value, 16);
    bytes += static_cast<char>(value);
  }
  return bytes;
}

}  // namespace microslip
