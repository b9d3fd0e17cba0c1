// SPDX-License-Identifier: MIT
#include "microslip/io/config/toml_nesting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"

namespace microslip {
namespace {

constexpr int kMostKeyParts = 16;

/// The offset behind the comment that starts at `start`.
std::size_t comment_end(std::string_view text, std::size_t start) {
  return std::min(text.find('\n', start), text.size());
}

/// The offset behind the text in quotes that starts at `start`; the end of the line, where the
/// parser gives up, if it is not closed.
std::size_t quoted_end(std::string_view text, std::size_t start) {
  const char quote = text[start];
  const std::string triple(3, quote);
  const bool is_long = text.substr(start, 3) == triple;
  for (std::size_t i = start + (is_long ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (!is_long && (text[i] == quote || text[i] == '\n')) {
      return i + 1;
    } else if (is_long && text.substr(i, 3) == triple) {
      // Up to two quotes before the closing three belong to the text.
      const std::size_t after = std::min(text.find_first_not_of(quote, i + 3), text.size());
      return std::min(after, i + 5);
    }
  }
  return text.size();
}

bool continues_key(char c) {
  return c == ' ' || c == '\t' || c == '-' || c == '_' || (c >= '0' && c <= '9') ||
         (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

}  // namespace

void check_toml_nesting(std::string_view text, std::string_view file) {
  int depth = 0;
  int parts = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = quoted_end(text, i);
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == '.') {
      ++parts;
    } else if (!continues_key(c)) {
      parts = 1;
    }
    if (depth > kDeepestNesting) {
      throw FormatError(place_at(text, i, file),
                        fmt::format("at most {} nested arrays and tables", kDeepestNesting),
                        "more");
    }
    if (parts > kMostKeyParts) {
      throw FormatError(place_at(text, i, file),
                        fmt::format("at most {} parts in a dotted key", kMostKeyParts), "more");
    }
    i = c == '#' ? comment_end(text, i) : i + 1;
  }
}

}  // namespace microslip
