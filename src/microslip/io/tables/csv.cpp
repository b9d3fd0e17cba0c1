// SPDX-License-Identifier: MIT
#include "microslip/io/tables/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {

/// One pass over the text. Cells that from_chars can read in place are numbers at once; the others
/// are marked as text.
class CsvTable::Parser {
 public:
  /// @param begin  where the rows begin in the text.
  Parser(CsvTable& table, std::size_t begin)
      : table_(table),
        text_(table.text_),
        end_(text_.data() + text_.size()),
        position_(text_.data() + begin),
        scanner_(text_, table.file_, table.separator_) {}

  void parse_rows() {
    const char* start = position_;
    const std::size_t comments = table_.comments_.size();
    if (!read_rows()) {
      position_ = start;
      table_.decimal_comma_ = true;
      table_.comments_.resize(comments);
      table_.row_start_.clear();
      table_.values_.clear();
      table_.text_cells_.clear();
      read_rows();
    }
    if (table_.rows() == 0) {
      throw FormatError(scanner_.place(end_), "a row of values below the header",
                        "the end of the file", "Was it written to its end?");
    }
  }

 private:
  [[nodiscard]] std::size_t offset(const char* p) const {
    return static_cast<std::size_t>(p - text_.data());
  }

  /// False where a decimal comma turns up in a table that was read with decimal points so far.
  bool read_rows() {
    while (position_ != end_) {
      if (scanner_.skip_blank_or_comment(position_, table_.comments_)) continue;
      if (!read_row()) return false;
    }
    return true;
  }

  bool read_row() {
    const std::size_t first_value = table_.values_.size();
    const char* start = position_;
    table_.row_start_.push_back(offset(start));
    bool last_is_empty = false;
    for (;;) {
      double value = 0.0;
      const char* next = table_.decimal_comma_ ? nullptr : read_plain_number(value);
      last_is_empty = false;
      if (next == nullptr) {
        const RawCell cell = scanner_.scan(position_);
        if (!read_other_cell(cell, value)) return false;
        last_is_empty = cell.begin == cell.end;
        next = cell.next;
      }
      table_.values_.push_back(value);
      if (scanner_.at_line_end(next)) {
        position_ = scanner_.skip_line_end(next);
        break;
      }
      position_ = next + 1;
    }
    finish_row(start, table_.values_.size() - first_value, last_is_empty);
    return true;
  }

  /// The common case without a look for the cell's end: where from_chars stops, the cell must stop.
  const char* read_plain_number(double& value) const {
    const char* p = scanner_.skip_blanks(position_);
    if (end_ - p > 1 && *p == '+' && p[1] != '-') ++p;
    const auto [stop, error] = std::from_chars(p, end_, value);
    if (error != std::errc{} || !std::isfinite(value)) {
      value = 0.0;
      return nullptr;
    }
    const char* next = scanner_.skip_blanks(stop);
    return scanner_.at_cell_end(next) ? next : nullptr;
  }

  bool read_other_cell(const RawCell& cell, double& value) {
    const bool may_have_comma = table_.separator_ != ',';
    std::optional<double> number =
        table_.decimal_comma_ ? parse_comma_number(cell.view()) : parse_number(cell.view());
    if (!number && may_have_comma && !table_.decimal_comma_ && parse_comma_number(cell.view())) {
      return false;
    }
    if (!number) table_.text_cells_.push_back(table_.values_.size());
    value = number.value_or(0.0);
    return true;
  }

  void finish_row(const char* start, std::size_t cells, bool last_is_empty) {
    const std::size_t columns = table_.columns_.size();
    if (cells == columns + 1 && last_is_empty) {
      table_.values_.pop_back();
      table_.text_cells_.pop_back();
      --cells;
    }
    if (cells == columns) return;
    throw ragged_row(scanner_.place(start), columns, cells, table_.separator_);
  }

  CsvTable& table_;
  std::string_view text_;
  const char* end_;
  const char* position_;
  CellScanner scanner_;
};

namespace {

RawCell find_cell(std::string_view text, std::string_view file, char separator,
                  std::size_t row_start, std::size_t column) {
  const CellScanner scanner(text, file, separator);
  RawCell cell = scanner.scan(text.data() + row_start);
  for (; column > 0; --column) cell = scanner.scan(cell.next + 1);
  return cell;
}

}  // namespace

CsvTable::CsvTable(std::string text, std::string_view file) : text_(std::move(text)), file_(file) {
  const KnownKind* const known = known_kind_of(text_);
  const bool is_other = known != nullptr && known->format != KindFormat::kTable;
  const std::string_view other = is_other ? known->words : signature(text_);
  if (!other.empty()) {
    throw FormatError(
        {file_, 0, 0}, "a table of comma-separated values", other,
        is_other ? std::string_view("Is it the right file?") : remedy_for_signature(other));
  }
  CsvHeader header = parse_csv_header(text_, file_);
  separator_ = header.separator;
  header_start_ = header.start;
  columns_ = std::move(header.columns);
  comments_ = std::move(header.comments);
  Parser(*this, header.end).parse_rows();
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const {
  const auto found = std::find_if(columns_.begin(), columns_.end(),
                                  [&](const CsvColumn& column) { return column.name == name; });
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvTable::require(std::string_view name, std::string_view header) const {
  const std::optional<std::size_t> column = find(name);
  if (column) return *column;
  std::string names;
  for (const CsvColumn& c : columns_) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", c.name);
  }
  const KnownKind* const known = known_kind_of(text_);
  const std::string_view rule = columns_.size() == 1
                                    ? "Is this line the header? Lines above it begin with '#'."
                                    : "Names are case-sensitive; write units in square brackets.";
  throw FormatError(
      place_at(text_, header_start_, file_), fmt::format("a column '{}'", header),
      fmt::format("the columns {}", in_quotes(names, 120)),
      fmt::format("{}{}", known == nullptr ? "" : fmt::format("This looks like {}. ", known->words),
                  rule));
}

std::string CsvTable::label(std::size_t column) const {
  const CsvColumn& c = columns_[column];
  return fmt::format("column {} {}", column + 1,
                     in_quotes(c.unit ? fmt::format("{} [{}]", c.name, *c.unit) : c.name));
}

Unit CsvTable::unit_of(std::size_t column, const Dimension& expected) const {
  const CsvColumn& c = columns_[column];
  const auto place = [&] {
    const RawCell cell = find_cell(text_, file_, separator_, header_start_, column);
    return place_at(text_, static_cast<std::size_t>(cell.begin - text_.data()), file_);
  };
  const std::string rule =
      fmt::format("a unit of {} for column {}", dimension_name(expected), column + 1);
  if (!c.unit) {
    throw FormatError(place(), rule, fmt::format("{} without one", in_quotes(c.name)),
                      fmt::format("Write '{} [{}]'.", c.name, si_unit(expected)));
  }
  const std::optional<Unit> unit = find_unit(*c.unit);
  const std::string remedy = c.unit->find('[') != std::string::npos
                                 ? "Separate columns by commas, semicolons or tabs."
                                 : fmt::format("Units that fit: {}.", usual_units(expected));
  if (!unit) {
    throw FormatError(
        place(), rule,
        fmt::format("the unknown unit {} of {}", in_quotes(*c.unit), in_quotes(c.name)), remedy);
  }
  if (unit->dimension != expected) {
    throw FormatError(place(), rule,
                      fmt::format("{}, a unit of {}, for {}", in_quotes(*c.unit),
                                  dimension_name(unit->dimension), in_quotes(c.name)),
                      remedy);
  }
  return *unit;
}

std::vector<double> CsvTable::numbers(std::string_view name, const Dimension& expected) const {
  const std::size_t column = require(name, fmt::format("{} [{}]", name, si_unit(expected)));
  const Unit unit = unit_of(column, expected);
  const std::size_t width = columns_.size();
  for (const std::size_t index : text_cells_) {
    if (index % width == column) reject_number(index / width, column);
  }
  std::vector<double> result(rows());
  for (std::size_t row = 0; row < result.size(); ++row) {
    result[row] = unit.to_si(values_[row * width + column]);
    if (!std::isfinite(result[row])) reject_number(row, column);
  }
  return result;
}

std::vector<double> CsvTable::numbers_if_present(std::string_view name,
                                                 const Dimension& expected) const {
  return has(name) ? numbers(name, expected) : std::vector<double>{};
}

std::vector<std::string> CsvTable::text(std::string_view name) const {
  const std::size_t column = require(name, name);
  std::vector<std::string> result;
  result.reserve(rows());
  for (const std::size_t start : row_start_) {
    result.push_back(unescaped(find_cell(text_, file_, separator_, start, column)));
  }
  return result;
}

std::vector<std::size_t> CsvTable::row_lines() const {
  std::vector<std::size_t> lines;
  lines.reserve(rows());
  std::size_t line = 1;
  auto position = text_.begin();
  for (const std::size_t start : row_start_) {
    const auto row = text_.begin() + static_cast<std::ptrdiff_t>(start);
    line += static_cast<std::size_t>(std::count(position, row, '\n'));
    position = row;
    lines.push_back(line);
  }
  return lines;
}

void CsvTable::reject(std::size_t row, std::string_view name, std::string_view expected,
                      std::string_view remedy) const {
  const std::size_t column = require(name, name);
  const RawCell cell = find_cell(text_, file_, separator_, row_start_[row], column);
  throw FormatError(place_at(text_, static_cast<std::size_t>(cell.begin - text_.data()), file_),
                    fmt::format("{} in {}", expected, label(column)),
                    cell.begin == cell.end ? "an empty cell" : in_quotes(cell.view()), remedy);
}

void CsvTable::reject_number(std::size_t row, std::size_t column) const {
  const RawCell cell = find_cell(text_, file_, separator_, row_start_[row], column);
  const std::string_view text = cell.view();
  std::string_view remedy = remedy_for_cell(text);
  if (decimal_comma_ && text.find('.') != std::string_view::npos) {
    remedy = "This table has decimal commas elsewhere: write all numbers one way.";
  }
  reject(row, columns_[column].name, "a finite number", remedy);
}

}  // namespace microslip
