// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace microslip {

/// One column of a table, from its header `name [unit]` or `name (unit)`.
struct CsvColumn {
  std::string name;                 ///< without outer blanks
  std::optional<std::string> unit;  ///< as written; nothing where the header has no brackets
};

}  // namespace microslip
