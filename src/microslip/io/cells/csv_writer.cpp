// SPDX-License-Identifier: MIT
#include "microslip/io/cells/csv_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"

namespace microslip {

void CsvWriter::add_comment(std::string_view text) { append_comment(comments_, text); }

void CsvWriter::check_column(std::string_view name, std::size_t size) const {
  check_column_name(name);
  if (!columns_.empty() && size != rows_) {
    throw InputError(name, fmt::format("{} values", size),
                     fmt::format("must have {} values like the columns before it", rows_));
  }
}

void CsvWriter::add_numbers(std::string_view name, const Dimension& dimension,
                            std::span<const double> values) {
  check_column(name, values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw InputError(fmt::format("{}[{}]", name, i), values[i], "must be finite to be written");
    }
  }
  rows_ = values.size();
  columns_.push_back({.header = fmt::format("{} [{}]", name, si_unit(dimension)),
                      .numbers = {values.begin(), values.end()},
                      .texts = {},
                      .is_text = false});
}

void CsvWriter::add_numbers_or_empty(std::string_view name, const Dimension& dimension,
                                     std::span<const double> values) {
  check_column(name, values.size());
  rows_ = values.size();
  Column column{.header = fmt::format("{} [{}]", name, si_unit(dimension)),
                .numbers = {},
                .texts = {},
                .is_text = true};
  for (const double value : values) {
    column.texts.emplace_back();
    if (std::isfinite(value)) append_number(column.texts.back(), value);
  }
  columns_.push_back(std::move(column));
}

void CsvWriter::add_text(std::string_view name, std::span<const std::string> values) {
  check_column(name, values.size());
  rows_ = values.size();
  Column column{.header = std::string(name), .numbers = {}, .texts = {}, .is_text = true};
  std::transform(values.begin(), values.end(), std::back_inserter(column.texts), on_one_line);
  columns_.push_back(std::move(column));
}

std::string CsvWriter::str() const {
  if (rows_ == 0) throw InputError("rows", 0.0, "must be 1 or more in a table to be written");
  std::string text = comments_;
  for (const Column& column : columns_) {
    if (&column != columns_.data()) text += ',';
    append_text_cell(text, column.header);
  }
  text += '\n';
  for (std::size_t row = 0; row < rows_; ++row) {
    for (const Column& column : columns_) {
      if (&column != columns_.data()) text += ',';
      column.is_text ? append_text_cell(text, column.texts[row])
                     : append_number(text, column.numbers[row]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace microslip
