// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

/// @file
/// Cells of tables whose rows have quantities of their own. Internal to workflow.

namespace microslip {

class CsvTable;

/// The numbers of a column as they stand; NaN of cells that are empty.
/// @throws FormatError  where the column is missing or a cell holds anything else.
[[nodiscard]] std::vector<double> numbers_or_empty(const CsvTable& table, const std::string& name);

/// "frequency [Hz]" by its parts; the text and nothing where it is not like that.
[[nodiscard]] std::pair<std::string, std::string> name_and_unit(const std::string& text);

}  // namespace microslip
