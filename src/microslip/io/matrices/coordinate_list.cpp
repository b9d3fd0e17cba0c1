// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/coordinate_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/number_lines.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {
namespace {

/// Goes on to the next line that is no comment (% or #).
bool next_entry(NumberLines& lines) {
  while (lines.next()) {
    const std::string_view line = trimmed(lines.line());
    if (!line.starts_with('%') && !line.starts_with('#')) return true;
  }
  return false;
}

/// "12" and "1.2000000e+01", as programs write numbers of all kinds.
std::int32_t index_of(NumberLines& lines, std::string_view what) {
  const double number = lines.number(what);
  if (number >= 1.0 && number <= static_cast<double>(kMostDegreesOfFreedom) &&
      number == std::floor(number)) {
    return static_cast<std::int32_t>(number) - 1;
  }
  throw FormatError(lines.place(), fmt::format("{} from 1 to {}", what, kMostDegreesOfFreedom),
                    fmt::format("{:g}", number),
                    number == 0.0 ? "Rows and columns count from 1; add 1 to those of a program "
                                    "that counts from 0."
                                  : "");
}

/// Of the line that `lines` are at.
void add_coordinates(NumberLines& lines, MatrixEntries& entries) {
  entries.row.push_back(index_of(lines, "a row"));
  entries.column.push_back(index_of(lines, "a column"));
  entries.value.push_back(lines.number("a number"));
  lines.end();
  const std::int32_t last = std::max(entries.row.back(), entries.column.back());
  entries.size = std::max(entries.size, static_cast<std::size_t>(last) + 1);
}

/// Whether a first line of the last row and column is one of sizes: a list begins with the first
/// row or column behind it, or has that place again.
bool begins_behind(const MatrixEntries& entries) {
  const double count = entries.value[0];
  if (count < 1.0 || count != std::floor(count) || entries.size < 2) return false;
  if (entries.row[1] == 0 || entries.column[1] == 0) return true;
  for (std::size_t i = 1; i < entries.value.size(); ++i) {
    if (entries.row[i] == entries.row[0] && entries.column[i] == entries.column[0]) return true;
  }
  return false;
}

/// A first line of rows, columns and number of entries, as some programs write, is none of these.
/// False where there is none. @throws FormatError  where it states another number than there are.
bool drop_sizes(MatrixEntries& entries, const TextPlace& end) {
  const std::size_t others = entries.value.size() - 1;
  const bool is_last = static_cast<std::size_t>(entries.row[0]) + 1 == entries.size &&
                       entries.row[0] == entries.column[0];
  if (!is_last || others == 0) return false;
  if (entries.value[0] != static_cast<double>(others)) {
    if (!begins_behind(entries)) return false;
    throw FormatError(
        end, fmt::format("{} entries, which the first line states", entries.value[0]),
        std::to_string(others),
        "The file is truncated, or its first line is an entry: then put it behind the others.");
  }
  entries.row.erase(entries.row.begin());
  entries.column.erase(entries.column.begin());
  entries.value.erase(entries.value.begin());
  return true;
}

SymmetricEntries symmetric_of_list(MatrixEntries entries, std::string_view file) {
  if (has_both_triangles(entries)) {
    return symmetric_of_both(entries, file,
                             "It has some entries of both triangles: all must be there, or those "
                             "of one.");
  }
  return symmetric_of_triangle(std::move(entries), file);
}

}  // namespace

bool is_coordinate_list(std::string_view head) {
  if (head.starts_with("%%")) return false;  // the banner of Matrix Market
  NumberLines lines(head, "");
  if (!next_entry(lines)) return false;
  try {
    for (const char* what : {"a row", "a column"}) {
      const double number = lines.number(what);
      if (number < 0.0 || number != std::floor(number)) return false;
    }
    (void)lines.number("a number");
    lines.end();
  } catch (const FormatError&) {
    return false;
  }
  return true;
}

SymmetricEntries parse_coordinate_list(std::string_view text, std::string_view file) {
  NumberLines lines(text, file);
  MatrixEntries entries{.size = 0, .row = {}, .column = {}, .value = {}};
  while (next_entry(lines)) add_coordinates(lines, entries);
  if (entries.value.empty()) {
    throw FormatError(lines.place(), "lines of row, column and value", "none");
  }
  const bool has_sizes = drop_sizes(entries, lines.place());
  SymmetricEntries matrix = symmetric_of_list(std::move(entries), file);
  matrix.is_open_ended = !has_sizes;
  return matrix;
}

SymmetricEntries read_coordinate_list(const std::string& path) {
  return parse_coordinate_list(read_text(path), input_name(path));
}

}  // namespace microslip
