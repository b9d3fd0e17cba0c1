// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/listed_units.hpp"

#include "microslip/io/bytes/text_pieces.hpp"

namespace microslip {

std::vector<std::string> listed_units(std::string_view text) {
  const std::vector<std::string_view> cells = comma_cells(text);
  std::vector<std::string> units(cells.begin(), cells.end());
  if (units.back().empty()) units.pop_back();
  return units;
}

}  // namespace microslip
