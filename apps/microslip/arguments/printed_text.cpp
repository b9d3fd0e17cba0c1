// SPDX-License-Identifier: MIT
#include "arguments/printed_text.hpp"

#include <algorithm>
#include <cstddef>

#include "microslip/io/bytes/text.hpp"

namespace microslip::app {

std::string printed_text(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += printable(text.substr(0, end));
    if (end < text.size()) lines += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void print_text(std::FILE* stream, std::string_view text) {
  const std::string printed = printed_text(text);
  std::fwrite(printed.data(), 1, printed.size(), stream);
}

}  // namespace microslip::app
