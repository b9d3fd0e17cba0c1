// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/listed_units.hpp"

#include "microslip/io/bytes/text.hpp"

namespace microslip {

std::vector<std::string> listed_units(std::string_view text) {
  std::vector<std::string> units;
  for (;;) {
    const std::size_t end = text.find(',');
    units.emplace_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  if (units.back().empty()) units.pop_back();
  return units;
}

}  // namespace microslip
