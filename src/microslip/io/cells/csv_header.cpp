// SPDX-License-Identifier: MIT
#include "microslip/io/cells/csv_header.hpp"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"

namespace microslip {
namespace {

constexpr std::string_view kExampleHeader = "'amplitude [m],dissipation [J]'";

/// Parentheses are part of a name, as in "D (left)", unless they hold a unit.
std::optional<CsvColumn> column_of(std::string_view text) {
  if (text.find('[') == std::string_view::npos) {
    std::optional<CsvColumn> column = parse_column(text, true);
    if (column && column->unit && find_unit(*column->unit) && !column->name.empty()) return column;
  }
  return parse_column(text, false);
}

class HeaderParser {
 public:
  HeaderParser(std::string_view text, std::string_view file, bool names_differ)
      : text_(text),
        file_(file),
        names_differ_(names_differ),
        end_(text.data() + text.size()),
        position_(text.data()),
        scanner_(text, file, ',') {}

  CsvHeader parse() {
    if (text_.starts_with(kByteOrderMark)) position_ += kByteOrderMark.size();
    while (position_ != end_ && scanner_.skip_blank_or_comment(position_, header_.comments)) {
    }
    if (position_ == end_) {
      throw FormatError({std::string(file_), 0, 0},
                        fmt::format("a header such as {}", kExampleHeader),
                        text_.empty() ? "an empty file" : "nothing but blanks and comments",
                        "Was it written to its end?");
    }
    header_.start = offset(position_);
    const std::string_view rest = text_.substr(header_.start);
    header_.separator = find_separator(rest.substr(0, rest.find('\n')));
    scanner_ = CellScanner(text_, file_, header_.separator);
    read_columns();
    header_.end = offset(position_);
    return std::move(header_);
  }

 private:
  [[nodiscard]] std::size_t offset(const char* p) const {
    return static_cast<std::size_t>(p - text_.data());
  }

  void read_columns() {
    std::unordered_map<std::string, std::size_t> seen;
    bool all_numbers = true;
    for (;;) {
      const RawCell cell = scanner_.scan(position_);
      const bool last = scanner_.at_line_end(cell.next);
      const bool trailing = last && cell.begin == cell.end && !header_.columns.empty();
      if (!trailing) {
        all_numbers = all_numbers && parse_number(cell.view()).has_value();
        add_column(cell, seen);
      }
      position_ = last ? scanner_.skip_line_end(cell.next) : cell.next + 1;
      if (last) break;
    }
    if (all_numbers) {
      throw FormatError(place_at(text_, header_.start, file_),
                        fmt::format("a header such as {}", kExampleHeader), "a row of numbers",
                        "Add a first line that names each column with its unit.");
    }
  }

  void add_column(const RawCell& cell, std::unordered_map<std::string, std::size_t>& seen) {
    const std::string text = unescaped(cell);
    const std::size_t number = header_.columns.size() + 1;
    if (trimmed(text.substr(0, text.find('['))).empty()) {
      throw FormatError(scanner_.place(cell.begin), fmt::format("a name for column {}", number),
                        text.empty() ? "an empty cell" : in_quotes(text));
    }
    std::optional<CsvColumn> column = column_of(text);
    if (!column) {
      throw FormatError(scanner_.place(cell.begin),
                        fmt::format("'name [unit]' as the header of column {}", number),
                        in_quotes(text));
    }
    const auto [first, is_new] = seen.emplace(column->name, number);
    if (!is_new && names_differ_) {
      throw FormatError(scanner_.place(cell.begin), "columns with different names",
                        fmt::format("{} as column {} and as column {}", in_quotes(column->name),
                                    first->second, number),
                        "Rename or remove one of them.");
    }
    header_.columns.push_back(std::move(*column));
  }

  std::string_view text_;
  std::string_view file_;
  bool names_differ_;
  const char* end_;
  const char* position_;
  CellScanner scanner_;
  CsvHeader header_;
};

}  // namespace

CsvHeader parse_csv_header(std::string_view text, std::string_view file, bool names_differ) {
  return HeaderParser(text, file, names_differ).parse();
}

std::vector<CsvColumn> csv_columns(std::string_view head) {
  if (!signature(head).empty()) return {};
  try {
    return parse_csv_header(head, {}, false).columns;
  } catch (const FormatError&) {
    return {};
  }
}

std::vector<std::string> csv_column_names(std::string_view head) {
  std::vector<std::string> names;
  for (CsvColumn& column : csv_columns(head)) names.push_back(std::move(column.name));
  return names;
}

}  // namespace microslip
