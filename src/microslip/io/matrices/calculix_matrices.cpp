// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/calculix_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/number_lines.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {
namespace {

std::optional<NodalDirection> direction_of(std::string_view text) {
  for (std::size_t i = 0; i < kNodalDirections; ++i) {
    const bool number = text.size() == 1 && text[0] == static_cast<char>('1' + i);
    if (number || text == kNodalDirectionNames[i]) return static_cast<NodalDirection>(i);
  }
  return std::nullopt;
}

std::optional<DegreeOfFreedom> degree_of(std::string_view line) {
  DegreeOfFreedom degree;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), degree.node);
  if (error != std::errc()) return std::nullopt;
  std::string_view rest = line.substr(static_cast<std::size_t>(end - line.data()));
  const std::size_t separator = rest.find_first_not_of(". ,\t");
  if (separator == 0 || separator == std::string_view::npos) return std::nullopt;
  const std::optional<NodalDirection> direction = direction_of(trimmed(rest.substr(separator)));
  if (!direction) return std::nullopt;
  degree.direction = *direction;
  return degree;
}

/// The largest number at the start of a line.
std::size_t largest_row(std::string_view text, std::string_view file) {
  std::size_t largest = 0;
  NumberLines lines(text, file);
  while (lines.next()) {
    largest = std::max(largest, static_cast<std::size_t>(std::max<std::int64_t>(
                                    lines.integer("a row"), lines.integer("a column"))));
  }
  return largest;
}

/// The numbers of rows and of lines, where they differ, say more than the first entry beyond.
SymmetricEntries read_triangle(const std::string& job, std::string_view ending, std::size_t size) {
  const std::string file = fmt::format("{}{}", job, ending);
  const std::string text = read_text(file);
  try {
    return parse_triangle(text, file, size);
  } catch (const FormatError&) {
    const std::size_t rows = largest_row(text, file);
    if (rows <= size) throw;
    const std::string_view remedy =
        rows == 2 * size ? "They are real and imaginary part of a cyclic sector (*CYCLIC SYMMETRY "
                           "MODEL), which is not read: model the whole ring."
                         : "Both must be of the same run of CalculiX.";
    throw FormatError({file, 0, 0}, fmt::format("{} rows, the lines of {}.dof", size, job),
                      fmt::format("{} rows", rows), remedy);
  }
}

bool have_repeated(std::vector<DegreeOfFreedom> degrees) {
  std::ranges::sort(degrees);
  return std::ranges::adjacent_find(degrees) != degrees.end();
}

}  // namespace

SymmetricEntries parse_triangle(std::string_view text, std::string_view file, std::size_t size) {
  NumberLines lines(text, file);
  MatrixEntries entries{.size = size, .row = {}, .column = {}, .value = {}};
  while (lines.next()) {
    const std::int32_t row = lines.index("a row", size);
    const std::int32_t column = lines.index("a column", size);
    const double value = lines.number("a number");
    lines.end();
    if (value == 0.0) continue;
    entries.row.push_back(row);
    entries.column.push_back(column);
    entries.value.push_back(value);
  }
  if (entries.value.empty()) {
    throw FormatError({std::string(file), 0, 0}, "lines of row, column and value", "none");
  }
  return symmetric_of_triangle(std::move(entries), file);
}

std::vector<DegreeOfFreedom> parse_degrees(std::string_view text, std::string_view file) {
  std::vector<DegreeOfFreedom> degrees;
  NumberLines lines(text, file);
  while (lines.next()) {
    const std::string_view line = trimmed(lines.line());
    if (line.starts_with('#')) continue;
    const bool carriage_return = line.ends_with('\r');
    const std::optional<DegreeOfFreedom> degree =
        degree_of(trimmed(carriage_return ? line.substr(0, line.size() - 1) : line));
    if (!degree) {
      throw FormatError(lines.place(), "a node and its direction, 12.3 or 12 z", in_quotes(line));
    }
    degrees.push_back(*degree);
  }
  if (!degrees.empty()) return degrees;
  throw FormatError({std::string(file), 0, 0}, "one line per row of the matrices", "none");
}

std::vector<DegreeOfFreedom> read_degrees(const std::string& path) {
  return parse_degrees(read_text(path), input_name(path));
}

StructuralMatrices read_calculix_matrices(const std::string& job) {
  for (const char* ending : {".dof", ".sti", ".mas"}) check_named_file(job + ending);
  StructuralMatrices matrices;
  matrices.degrees = parse_degrees(read_text(job + ".dof"), job + ".dof");
  matrices.expanded = have_repeated(matrices.degrees);
  const std::size_t size = matrices.degrees.size();
  matrices.stiffness = read_triangle(job, ".sti", size);
  matrices.mass = read_triangle(job, ".mas", size);
  return matrices;
}

}  // namespace microslip
