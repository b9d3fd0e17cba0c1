// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

using Kind = MatValue::Kind;

bool is_real_number(const MatValue& cell) {
  return cell.kind == Kind::kNumbers && cell.real.size() == 1 && cell.imaginary.empty();
}

const MatValue& cell_of(const MatValue& value, std::size_t row, std::size_t field) {
  return value.children[row * value.fields.size() + field];
}

/// The first row where the times of a field are no number above the one before; the number of rows
/// where they rise.
std::size_t row_that_does_not_rise(const MatValue& value, std::size_t field) {
  for (std::size_t row = 0; row < value.count(); ++row) {
    const MatValue& cell = cell_of(value, row, field);
    if (!is_real_number(cell)) return row;
    if (row > 0 && !(cell.real[0] > cell_of(value, row - 1, field).real[0])) return row;
  }
  return value.count();
}

/// The field of times: the first that rises, else the first; the number of fields where none is
/// called so.
std::size_t field_of_times(const MatValue& value) {
  std::size_t first = value.fields.size();
  for (std::size_t field = 0; field < value.fields.size(); ++field) {
    if (!is_one_of(value.fields[field], kTimeNames)) continue;
    if (row_that_does_not_rise(value, field) == value.count()) return field;
    first = std::min(first, field);
  }
  return first;
}

[[noreturn]] void fail(const std::string& place, const std::string& found,
                       std::string_view remedy) {
  throw FormatError({.file = place}, "rows of single numbers over a field 'time' that rises", found,
                    remedy);
}

/// The place and the contents of a cell.
std::string in_words(const MatValue& value, std::size_t row, std::size_t field) {
  const MatValue& cell = cell_of(value, row, field);
  const std::string what = is_real_number(cell) ? fmt::format("{}", cell.real[0])
                           : cell.count() == 0  ? "no number"
                                                : describe(cell);
  return fmt::format("{} in {} of row {}", what, in_quotes(value.fields[field]), row + 1);
}

void require_times(const MatValue& value, const std::string& place) {
  const std::size_t times = field_of_times(value);
  if (times == value.fields.size()) {
    fail(place, "the fields " + list_of_names(value.fields),
         "Call its times 'time', or save its fields as vectors of a struct, as in SciPy "
         "savemat(FILE, {name: table[name] for name in table.dtype.names}).");
  }
  const std::size_t row = row_that_does_not_rise(value, times);
  if (row == value.count()) return;
  const bool falls = row > 0 && is_real_number(cell_of(value, row, times));
  fail(
      place,
      falls ? fmt::format("{} after {}", in_words(value, row, times),
                          cell_of(value, row - 1, times).real[0])
            : in_words(value, row, times),
      "Take out rows without a time and rows that were recorded twice, and sort the others by it.");
}

/// The numbers of a field; none where it has text.
std::vector<double> column_of(const MatValue& value, std::size_t field, const std::string& place) {
  std::vector<double> column;
  column.reserve(value.count());
  for (std::size_t row = 0; row < value.count(); ++row) {
    const MatValue& cell = cell_of(value, row, field);
    if (is_real_number(cell)) {
      column.push_back(cell.real[0]);
    } else if (cell.kind != Kind::kText) {
      fail(place, in_words(value, row, field),
           cell.count() == 0 ? "Take the row out."
                             : "Take the field out, or save the fields as vectors and matrices of "
                               "a struct, as in SciPy savemat(FILE, {name: table[name] for name in "
                               "table.dtype.names}).");
    }
  }
  if (column.size() < value.count()) column.clear();
  return column;
}

}  // namespace

bool is_table_of_rows(const MatValue& value) {
  const std::size_t rows = value.count();
  if (rows < 2 || value.children.size() != rows * value.fields.size()) return false;
  const auto is_single = [](const MatValue& cell) {
    return cell.kind == Kind::kText || (cell.kind == Kind::kNumbers && cell.count() <= 1);
  };
  if (std::ranges::all_of(value.children, is_single)) return true;
  const auto is_cell = [&](const MatValue& cell) {
    return is_single(cell) || (cell.kind == Kind::kNumbers && cell.count() < rows);
  };
  const std::size_t times = field_of_times(value);
  return times < value.fields.size() && row_that_does_not_rise(value, times) == rows &&
         std::ranges::all_of(value.children, is_cell);
}

ColumnsOfRows columns_of_rows(const MatValue& value, const std::string& place) {
  require_times(value, place);
  ColumnsOfRows columns;
  columns.table.kind = Kind::kStruct;
  columns.table.sizes = {1, 1};
  for (std::size_t field = 0; field < value.fields.size(); ++field) {
    MatValue column;
    column.kind = Kind::kNumbers;
    column.sizes = {value.count(), 1};
    column.real = column_of(value, field, place);
    if (column.real.empty()) {
      columns.left_out.push_back(value.fields[field]);
    } else {
      columns.table.fields.push_back(value.fields[field]);
      columns.table.children.push_back(std::move(column));
    }
  }
  return columns;
}

}  // namespace microslip
