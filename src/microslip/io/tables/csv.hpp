// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/io/cells/csv_column.hpp"
#include "microslip/io/cells/csv_header.hpp"

namespace microslip {

/// A table with named columns in comma-separated text.
///
/// Form: UTF-8 with or without byte order mark; lines end in LF or CRLF. The first line that is
/// neither blank nor a comment (`#` first) is the header. The separator is the first of `;` `,` tab
/// that the header has. Cells may be quoted ("…", a quote inside is doubled, no line break inside);
/// one separator at the end of a line is tolerated. Numbers have a decimal point, or, between `;`
/// or tabs, a decimal comma throughout. Comments and blank lines may stand anywhere.
///
/// Cells are read as numbers or as text when a column is asked for; a column that is not requested
/// may hold anything. Every message names file, line and column, the cell and the rule.
class CsvTable {
 public:
  /// @param text  the file's whole text.
  /// @param file  its name, for messages.
  /// @throws FormatError  where the text is no table: empty, binary, no header, no row, two columns
  ///                      of one name, a row with more or fewer cells than the header.
  CsvTable(std::string text, std::string_view file);

  /// The name of the file, as given.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// The number of rows below the header.
  [[nodiscard]] std::size_t rows() const { return row_start_.size(); }
  /// The columns, in their order.
  [[nodiscard]] std::span<const CsvColumn> columns() const { return columns_; }
  /// Whether there is a column of this name.
  [[nodiscard]] bool has(std::string_view name) const { return find(name).has_value(); }

  /// The comment lines in their order, without `#` and outer blanks.
  [[nodiscard]] std::span<const std::string> comments() const { return comments_; }

  /// The numbers of a column, in SI.
  /// @throws FormatError  where the column is missing, has no unit or one of another dimension, or
  ///                      a cell is no finite number.
  [[nodiscard]] std::vector<double> numbers(std::string_view name, const Dimension& expected) const;

  /// The same; empty where there is no such column.
  [[nodiscard]] std::vector<double> numbers_if_present(std::string_view name,
                                                       const Dimension& expected) const;

  /// The cells of a column as they stand, without quotes and outer blanks.
  /// @throws FormatError  where the column is missing.
  [[nodiscard]] std::vector<std::string> text(std::string_view name) const;

  /// The line of each row, from 1.
  [[nodiscard]] std::vector<std::size_t> row_lines() const;

  /// For a reader whose rule a value breaks.
  /// @param row       of the cell, from 0.
  /// @param name      of its column.
  /// @param expected  as in "a positive amplitude".
  /// @param remedy    what to do about it, a sentence; may be empty.
  /// @throws FormatError  always: at the cell, with the cell's text as what was found.
  [[noreturn]] void reject(std::size_t row, std::string_view name, std::string_view expected,
                           std::string_view remedy = {}) const;

 private:
  class Parser;

  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  [[nodiscard]] std::size_t require(std::string_view name, std::string_view header) const;
  [[nodiscard]] Unit unit_of(std::size_t column, const Dimension& expected) const;
  [[nodiscard]] std::string label(std::size_t column) const;
  [[noreturn]] void reject_number(std::size_t row, std::size_t column) const;

  std::string text_;
  std::string file_;
  char separator_ = ',';
  bool decimal_comma_ = false;
  std::size_t header_start_ = 0;
  std::vector<CsvColumn> columns_;
  std::vector<std::string> comments_;
  std::vector<std::size_t> row_start_;   ///< offsets into text_
  std::vector<double> values_;           ///< row by row; 0 where the cell is no finite number
  std::vector<std::size_t> text_cells_;  ///< indices into values_ of those cells, rising
};

}  // namespace microslip
