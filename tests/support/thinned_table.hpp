// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

namespace microslip::testing {

/// A table of fewer levels, of each mode: the header and every third row from the first on.
inline std::string every_third_row(const std::string& table) {
  std::istringstream lines(table);
  std::string result;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    if (number == 0 || number % 3 == 1) result += line + "\n";
  }
  return result;
}

}  // namespace microslip::testing
