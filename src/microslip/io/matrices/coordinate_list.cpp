// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/coordinate_list.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/cells/number_lines.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {
namespace {

/// Of the line that `lines` are at.
void add_coordinates(NumberLines& lines, MatrixEntries& entries) {
  entries.row.push_back(lines.index("a row", kMostDegreesOfFreedom));
  entries.column.push_back(lines.index("a column", kMostDegreesOfFreedom));
  entries.value.push_back(lines.number("a number"));
  lines.end();
  const std::int32_t last = std::max(entries.row.back(), entries.column.back());
  entries.size = std::max(entries.size, static_cast<std::size_t>(last) + 1);
}

}  // namespace

bool is_coordinate_list(std::string_view head) {
  NumberLines lines(head, "");
  MatrixEntries entries{.size = 0, .row = {}, .column = {}, .value = {}};
  if (!lines.next()) return false;
  try {
    add_coordinates(lines, entries);
  } catch (const FormatError&) {
    return false;
  }
  return true;
}

SymmetricEntries parse_coordinate_list(std::string_view text, std::string_view file) {
  NumberLines lines(text, file);
  MatrixEntries entries{.size = 0, .row = {}, .column = {}, .value = {}};
  while (lines.next()) add_coordinates(lines, entries);
  if (has_both_triangles(entries)) {
    return symmetric_of_both(entries, file,
                             "It has some entries of both triangles: all must be there, or those "
                             "of one.");
  }
  return symmetric_of_triangle(std::move(entries), file);
}

SymmetricEntries read_coordinate_list(const std::string& path) {
  return parse_coordinate_list(read_text(path), input_name(path));
}

}  // namespace microslip
