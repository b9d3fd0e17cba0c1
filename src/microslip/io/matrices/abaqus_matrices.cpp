// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/abaqus_matrices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/matrices/degree_entries.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

constexpr std::size_t kAbaqusHead = 65536;  // comments may fill much of it
constexpr std::size_t kAbaqusCells = 5;

/// A cell, and the column of the line that it begins in, from 1.
struct AbaqusCell {
  std::string_view text;
  std::size_t column = 1;
};

/// Of a line with four commas.
std::optional<std::array<AbaqusCell, kAbaqusCells>> abaqus_cells(std::string_view line) {
  if (std::ranges::count(line, ',') != kAbaqusCells - 1) return std::nullopt;
  std::array<AbaqusCell, kAbaqusCells> cells;
  std::size_t begin = 0;
  for (AbaqusCell& cell : cells) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cell = {trimmed(line.substr(begin, end - begin)), begin + 1};
    begin = end + 1;
  }
  return cells;
}

bool is_entry(std::string_view line) {
  const auto cells = abaqus_cells(line);
  if (!cells) return false;
  for (std::size_t i = 0; i + 1 < kAbaqusCells; ++i) {
    if (!whole_integer((*cells)[i].text)) return false;
  }
  return uff_number(cells->back().text).has_value();
}

bool is_matrix_keyword(std::string_view line) {
  return in_capitals(line).starts_with("*MATRIX INPUT");
}

/// The lines that are neither blank nor comments, without what ends them.
class AbaqusLines {
 public:
  explicit AbaqusLines(std::string_view text) : rest_(text) {}

  bool next() {
    while (!rest_.empty()) {
      line_ = take_dos_line(rest_);
      ++number_;
      if (!trimmed(line_).empty() && !line_.starts_with("**")) return true;
    }
    return false;
  }

  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

class AbaqusMatrix {
 public:
  explicit AbaqusMatrix(const AbaqusSource& source) : file_(source.file) {
    AbaqusLines lines(source.text);
    bool named = false;
    while (lines.next()) {
      line_ = lines.number();
      if (is_matrix_keyword(lines.line())) {
        if (named) throw FormatError(place(1), "one matrix", "another *MATRIX INPUT");
        named = true;
      } else {
        add(lines.line());
      }
    }
    require_whole_lines(source.text, place(1));
  }

  DegreeMatrix take() && {
    return {.name = file_,
            .triangles = DegreeMatrix::Triangles::kEither,
            .entries = std::move(entries_),
            .twice = "those that are there twice would add up",
            .lacks =
                "The file has some entries of both triangles: it must have all, or those of "
                "one."};
  }

 private:
  [[nodiscard]] TextPlace place(std::size_t column) const { return {file_, line_, column}; }

  void add(std::string_view line) {
    const auto cells = abaqus_cells(line);
    if (!cells) {
      throw FormatError(place(1), "node, degree of freedom, node, degree of freedom, value",
                        in_quotes(line));
    }
    const auto& [row, row_direction, column, column_direction, value] = *cells;
    const std::optional<double> number = uff_number(value.text);
    if (!number || !std::isfinite(*number)) {
      throw FormatError(place(value.column), "a finite number", in_quotes(value.text));
    }
    entries_.push_back({degree(row, row_direction), degree(column, column_direction), *number});
  }

  [[nodiscard]] DegreeOfFreedom degree(const AbaqusCell& node, const AbaqusCell& direction) const {
    const std::optional<std::int64_t> number = whole_integer(node.text);
    if (!number)
      throw FormatError(place(node.column), "the number of a node", in_quotes(node.text));
    const std::optional<std::int64_t> freedom = whole_integer(direction.text);
    if (!freedom || *freedom < 1 || *freedom > static_cast<std::int64_t>(kNodalDirections)) {
      throw FormatError(place(direction.column), "a degree of freedom from 1 to 6",
                        in_quotes(direction.text),
                        "Others, as warping, pressure and temperature, are no displacements: "
                        "generate the matrices of a model without them.");
    }
    return {.node = *number, .direction = static_cast<NodalDirection>(*freedom - 1)};
  }

  std::string file_;
  std::size_t line_ = 0;
  std::vector<DegreeEntry> entries_;
};

}  // namespace

bool is_abaqus_matrix(std::string_view head) {
  AbaqusLines lines(head);
  while (lines.next()) {
    if (!is_matrix_keyword(lines.line())) return is_entry(lines.line());
  }
  return false;
}

bool is_abaqus_matrix_file(const std::string& path) {
  std::string head = read_file_head(part_of_file(path).file, kAbaqusHead);
  if (head.size() == kAbaqusHead) head.resize(head.rfind('\n') + 1);
  return is_abaqus_matrix(head);
}

StructuralMatrices parse_abaqus_matrices(const AbaqusSource& stiffness, const AbaqusSource& mass) {
  const DegreeMatrix k = AbaqusMatrix(stiffness).take();
  return matrices_of(k, AbaqusMatrix(mass).take());
}

StructuralMatrices read_abaqus_matrices(const std::string& stiffness, const std::string& mass) {
  const std::string k = read_text(stiffness);
  const std::string m = read_text(mass);
  return parse_abaqus_matrices({k, input_name(stiffness)}, {m, input_name(mass)});
}

}  // namespace microslip
