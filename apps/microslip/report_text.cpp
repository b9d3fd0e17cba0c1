// SPDX-License-Identifier: MIT
#include "report_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace microslip::app {

std::string line(std::string_view name, std::string_view text) {
  return fmt::format("  {:<20} {}\n", name, text);
}

std::string wrapped(std::string_view first, std::string_view text, std::size_t indent) {
  constexpr std::size_t kTextWidth = 78;
  std::string result(first);
  std::size_t column = first.size();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column + end > kTextWidth && column > indent) {
      result.pop_back();  // the blank before the break
      result += "\n" + std::string(indent, ' ');
      column = indent;
    }
    result += text.substr(0, end);
    column += end;
    text.remove_prefix(end);
    if (!text.empty()) {
      text.remove_prefix(1);
      result += ' ';
      ++column;
    }
  }
  return result + "\n";
}

}  // namespace microslip::app
