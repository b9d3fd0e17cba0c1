// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "microslip/io/bytes/text.hpp"

/// @file
/// Lines, cells and whole numbers of a text: what readers of text have in common. Inline, for files
/// of millions of lines. Internal to io.

namespace microslip {

/// The next line, without its line feed. It is taken off `rest`; empty at the end.
[[nodiscard]] inline std::string_view take_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return line;
}

/// take_line() without the carriage return that DOS puts before a line feed.
[[nodiscard]] inline std::string_view take_dos_line(std::string_view& rest) {
  std::string_view line = take_line(rest);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The cells between commas, without blanks at both ends: one more than there are commas.
[[nodiscard]] inline std::vector<std::string_view> comma_cells(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    cells.push_back(trimmed(line.substr(at, comma - at)));
    at = comma + 1;
  }
  return cells;
}

/// The number that the whole text is; nothing where it is none or out of range, or has blanks or a
/// `+` before it.
template <class Number>
[[nodiscard]] std::optional<Number> whole_number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// whole_number() of an integer.
[[nodiscard]] inline std::optional<std::int64_t> whole_integer(std::string_view text) {
  return whole_number<std::int64_t>(text);
}

}  // namespace microslip
