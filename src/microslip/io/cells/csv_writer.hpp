// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/units.hpp"

namespace microslip {

/// Composes the text of a table that CsvTable reads back: comment lines, a header `name [unit]`,
/// rows between commas, line breaks LF. Each number is the shortest text that reads back as the
/// same double, whatever the locale.
class CsvWriter {
 public:
  /// One `#` line per line of the text, above the header.
  void add_comment(std::string_view text);

  /// A column of numbers in SI, labelled with the SI unit of the dimension.
  /// @param name       of the column; without [ ] , ; " # and tabs.
  /// @param dimension  of the values.
  /// @param values     finite; as many as in the other columns.
  /// @throws InputError  naming the column, where a value is not finite or the lengths differ.
  void add_numbers(std::string_view name, const Dimension& dimension,
                   std::span<const double> values);

  /// The same, with empty cells where a value is not finite.
  /// @throws InputError  where the lengths differ.
  void add_numbers_or_empty(std::string_view name, const Dimension& dimension,
                            std::span<const double> values);

  /// A column of text; control characters, line breaks among them, become blanks.
  /// @throws InputError  where the lengths differ.
  void add_text(std::string_view name, std::span<const std::string> values);

  /// The whole text. @throws InputError  where there is no column or no row.
  [[nodiscard]] std::string str() const;

 private:
  struct Column {
    std::string header;
    std::vector<double> numbers;
    std::vector<std::string> texts;
    bool is_text = false;
  };

  void check_column(std::string_view name, std::size_t size) const;

  std::string comments_;
  std::vector<Column> columns_;
  std::size_t rows_ = 0;
};

}  // namespace microslip
