// SPDX-License-Identifier: MIT
#include "microslip/workflow/summary_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace microslip {

std::string line(std::string_view name, std::string_view text) {
  return fmt::format("  {:<20} {}\n", name, text);
}

std::string wrapped(std::string_view first, std::string_view text, std::size_t indent,
                    std::size_t width) {
  std::string result(first);
  std::size_t column = first.size();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column + end > width && column > indent) {
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

std::string shortened(const std::string& source, std::size_t width) {
  std::string name = source.substr(source.find_last_of('/') + 1);
  std::ranges::replace_if(
      name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return name.size() <= width ? name : "~" + name.substr(name.size() - width + 1);
}

}  // namespace microslip
