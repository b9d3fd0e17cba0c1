// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/recordings/mat_tree.hpp"

/// @file
/// Tables over time that are stored row by row: an array of structs with a field per column, as
/// SciPy writes record arrays.

namespace microslip {

/// Whether an array of structs is a table of rows, well-formed or not, rather than a list of
/// recordings: each field has at most one number or a text; or times rise from row to row, and
/// others are arrays of less numbers than there are rows.
[[nodiscard]] bool is_table_of_rows(const MatValue& value);

/// The columns of such a table.
struct ColumnsOfRows {
  MatValue table;                     ///< a struct of one element, of column vectors
  std::vector<std::string> left_out;  ///< fields of text
};

/// @param place  of the table, for messages.
/// @throws FormatError  naming the field and the row where a cell is neither a real number nor a
///                      text, and where no field is a time that rises.
[[nodiscard]] ColumnsOfRows columns_of_rows(const MatValue& value, const std::string& place);

}  // namespace microslip
