// SPDX-License-Identifier: MIT
#include "microslip/io/kinds/comment_text.hpp"

#include <array>

namespace microslip {

std::string_view comment_text(std::string_view line) {
  constexpr std::array<std::string_view, 5> kSigns{"# ", "** ", "! ", "// ", "/* "};
  for (const std::string_view sign : kSigns) {
    if (line.starts_with(sign)) return line.substr(sign.size());
  }
  return {};
}

}  // namespace microslip
