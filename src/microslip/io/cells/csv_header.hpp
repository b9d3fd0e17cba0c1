// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/cells/csv_column.hpp"

/// @file
/// The header of comma-separated text: which columns a table has.

namespace microslip {

/// Lines above the rows of a table, see CsvTable.
struct CsvHeader {
  char separator = ',';                    ///< of the cells of the table
  std::size_t start = 0;                   ///< where the header begins in the text
  std::size_t end = 0;                     ///< where the line behind it begins
  std::vector<CsvColumn> columns = {};     ///< in their order
  std::vector<std::string> comments = {};  ///< above it, without `#` and outer blanks
};

/// @param text          the file's text, as far as there is need of it.
/// @param file          its name, for messages.
/// @param names_differ  whether two columns of one name are refused.
/// @throws FormatError  where there is no header.
[[nodiscard]] CsvHeader parse_csv_header(std::string_view text, std::string_view file,
                                         bool names_differ = true);

/// The columns of a table of which only the beginning is given, one that stands twice too: what
/// kind of table it is to be tells who will refuse it. Empty where it is none.
[[nodiscard]] std::vector<CsvColumn> csv_columns(std::string_view head);

/// Their names.
[[nodiscard]] std::vector<std::string> csv_column_names(std::string_view head);

}  // namespace microslip
