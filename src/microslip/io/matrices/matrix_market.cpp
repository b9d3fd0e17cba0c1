// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/matrix_market.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/number_lines.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {
namespace {

constexpr std::string_view kBanner = "%%matrixmarket";
/// "1 1 1\n" and "1\n": no entry takes less.
constexpr std::size_t kShortestEntry = 6;
constexpr std::size_t kShortestValue = 2;

struct Header {
  bool array = false;      ///< all values, column by column
  bool symmetric = false;  ///< one triangle
};

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

Header read_header(const NumberLines& lines) {
  const std::vector<std::string> words = words_of(lines.line());
  if (words.size() != 5 || words[0] != kBanner || words[1] != "matrix") {
    throw FormatError(lines.place(), "%%MatrixMarket matrix coordinate real symmetric",
                      in_quotes(lines.line()),
                      "Or lines of row, column and value, *MATRIX OUTPUT of Abaqus, "
                      "Harwell-Boeing, OP4, MATLAB or HDF5.");
  }
  Header header;
  header.array = words[2] == "array";
  header.symmetric = words[4] == "symmetric";
  if (!header.array && words[2] != "coordinate") {
    throw FormatError(lines.place(), "coordinate or array", in_quotes(words[2]));
  }
  if (words[3] != "real" && words[3] != "integer" && words[3] != "double") {
    throw FormatError(lines.place(), "a real or integer matrix", in_quotes(words[3]),
                      "Mass and stiffness are real.");
  }
  if (!header.symmetric && words[4] != "general") {
    throw FormatError(lines.place(), "a symmetric or general matrix", in_quotes(words[4]),
                      "Mass and stiffness are symmetric.");
  }
  return header;
}

std::size_t read_count(NumberLines& lines, std::string_view what) {
  const std::int64_t count = lines.integer(what);
  if (count >= 0) return static_cast<std::size_t>(count);
  throw FormatError(lines.place(), what, std::to_string(count));
}

void skip_comments(NumberLines& lines) {
  while (lines.next()) {
    if (!lines.line().starts_with('%')) return;
  }
  throw FormatError(lines.place(), "the numbers of rows, columns and entries",
                    "the end of the file");
}

std::size_t read_size(NumberLines& lines, std::string_view file) {
  const std::size_t rows = read_count(lines, "the number of rows");
  if (rows == 0 || rows > kMostDegreesOfFreedom) {
    throw FormatError(lines.place(),
                      fmt::format("a number of rows from 1 to {}", kMostDegreesOfFreedom),
                      std::to_string(rows));
  }
  const std::size_t columns = read_count(lines, "the number of columns");
  if (columns == rows) return rows;
  throw InputError(fmt::format("{}: columns", file), static_cast<double>(columns),
                   fmt::format("must be {}, the number of rows", rows));
}

/// A file cannot have more entries than fit into it: memory for them is not asked for.
void require_room(const NumberLines& lines, std::size_t count, std::size_t shortest) {
  // The last may end without a line break.
  const std::size_t room = (lines.bytes_left() + 1) / shortest;
  if (count <= room) return;
  throw FormatError(lines.place(), "a number of entries that the file has room for",
                    fmt::format("{}, where {} fit at most", count, room),
                    "The file is truncated, or its header is wrong.");
}

MatrixEntries read_coordinates(NumberLines& lines, std::size_t size) {
  const std::size_t count = read_count(lines, "the number of entries");
  lines.end();
  require_room(lines, count, kShortestEntry);
  MatrixEntries entries{.size = size, .row = {}, .column = {}, .value = {}};
  entries.row.reserve(count);
  entries.column.reserve(count);
  entries.value.reserve(count);
  while (lines.next()) {
    if (entries.value.size() == count) {
      throw FormatError(lines.place(), fmt::format("the end of the file after {} entries", count),
                        in_quotes(lines.line()));
    }
    entries.row.push_back(lines.index("a row", size));
    entries.column.push_back(lines.index("a column", size));
    entries.value.push_back(lines.number("a number"));
    lines.end();
  }
  if (entries.value.size() == count) return entries;
  throw FormatError(lines.place(), fmt::format("{} entries", count),
                    fmt::format("the end of the file after {}", entries.value.size()));
}

MatrixEntries read_array(NumberLines& lines, std::size_t size, bool symmetric) {
  lines.end();
  const std::size_t count = symmetric ? size * (size + 1) / 2 : size * size;
  require_room(lines, count, kShortestValue);
  MatrixEntries entries{.size = size, .row = {}, .column = {}, .value = {}};
  for (std::size_t column = 0; column < size; ++column) {
    for (std::size_t row = symmetric ? column : 0; row < size; ++row) {
      if (!lines.next()) {
        throw FormatError(lines.place(), fmt::format("{} values", count), "the end of the file");
      }
      const double value = lines.number("a number");
      lines.end();
      if (value == 0.0) continue;
      entries.row.push_back(static_cast<std::int32_t>(row));
      entries.column.push_back(static_cast<std::int32_t>(column));
      entries.value.push_back(value);
    }
  }
  if (!lines.next()) return entries;
  throw FormatError(lines.place(), fmt::format("the end of the file after {} values", count),
                    in_quotes(lines.line()));
}

}  // namespace

SymmetricEntries parse_matrix_market(std::string_view text, std::string_view file) {
  NumberLines lines(text, file);
  lines.next();
  const Header header = read_header(lines);
  skip_comments(lines);
  const std::size_t size = read_size(lines, file);
  MatrixEntries entries =
      header.array ? read_array(lines, size, header.symmetric) : read_coordinates(lines, size);
  return header.symmetric
             ? symmetric_of_triangle(std::move(entries), file)
             : symmetric_of_both(entries, file,
                                 "If only one triangle is stored, the file must state so.");
}

SymmetricEntries read_matrix_market(const std::string& path) {
  return parse_matrix_market(read_text(path), input_name(path));
}

}  // namespace microslip
