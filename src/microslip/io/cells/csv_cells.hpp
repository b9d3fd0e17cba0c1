// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_column.hpp"

/// @file
/// The cells of comma-separated text: where they end, what they hold, how they are written. What
/// reads tables (csv.hpp) and what reads recordings (recording_csv.hpp) share these rules.

namespace microslip {

/// The whole text as a finite number with a decimal point; a leading + is fine.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The same with a decimal comma.
[[nodiscard]] std::optional<double> parse_comma_number(std::string_view text);

/// A number as Fortran writes it with the letter D, 1.5D+00, or without a letter where the exponent
/// has three digits, 6.27905-105; with a decimal point.
[[nodiscard]] std::optional<double> parse_fortran_number(std::string_view text);

/// A number with its thousands apart, 1.234,56 or 1,234.56: both marks, groups of three digits.
/// @param decimal  '.' or ','.
[[nodiscard]] std::optional<double> parse_grouped_number(std::string_view text, char decimal);

/// The first of two numbers or more that Fortran wrote into columns of fixed width without a blank
/// between them, `-1.234E+00-5.678E+00`; each has a decimal point, and all but the first begin with
/// a sign. Empty where the text is anything else.
[[nodiscard]] std::string_view first_of_joined(std::string_view text);

/// The first of `;` tab `,` that stands in the line outside of quotes; `otherwise` where none does.
/// A tab beside a comma aligns cells, and does not separate them.
[[nodiscard]] char find_separator(std::string_view header, char otherwise = ',');

/// Whether a word between blanks belongs to the cell before it: a unit in brackets to its name, and
/// what stands within open brackets. In a line of units each has brackets of its own.
[[nodiscard]] bool continues_cell(std::string_view cell, std::string_view word);

/// The remedy where commas or blanks separate columns.
inline constexpr std::string_view kRemedyForDecimalCommas =
    "Decimal commas need ';' or tabs between the columns.";

/// How messages call a separator: "a tab", "','".
[[nodiscard]] std::string separator_name(char separator);

/// The error of a row that has more or fewer cells than the header has columns.
[[nodiscard]] FormatError ragged_row(const TextPlace& row, std::size_t columns, std::size_t cells,
                                     char separator);

/// A cell between `begin` and `end`, without quotes and outer blanks; `next` is at the separator,
/// the line break or the end of the text.
struct RawCell {
  const char* begin;
  const char* end;
  const char* next;
  bool quoted;

  [[nodiscard]] std::string_view view() const {
    return {begin, static_cast<std::size_t>(end - begin)};
  }
};

/// The text of a cell; a doubled quote in quotes becomes one, and the guard of append_text_cell()
/// goes.
[[nodiscard]] std::string unescaped(const RawCell& cell);

/// Name and unit of a column from the text of its header cell: `name [unit]`, and `name (unit)`
/// where `parentheses` may hold units too. Nothing where it has another form; the name may be
/// empty.
[[nodiscard]] std::optional<CsvColumn> parse_column(std::string_view text, bool parentheses);

/// The text fit for a line of a table: control characters, line breaks among them, become blanks,
/// and all else is as printable() has it.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// One `#` line per line of the text; control characters become blanks.
void append_comment(std::string& text, std::string_view comment);

/// The rule on the name of a column that is written. @throws InputError  where it would not read
/// back.
void check_column_name(std::string_view name);

/// Quoted where it would not read back as it is; empty cells too, which could make a blank line. A
/// text that begins with = + - or @ and is no number gets a single quote before it, or a
/// spreadsheet would compute it as a formula.
void append_text_cell(std::string& text, std::string_view cell);

/// Remedy for a cell that should be a number but is not: dates, times of the day, others.
[[nodiscard]] std::string_view remedy_for_cell(std::string_view cell);

/// Finds where cells end.
class CellScanner {
 public:
  /// @param first_line  the number of the line that the text begins with, in the file.
  CellScanner(std::string_view text, std::string_view file, char separator,
              std::size_t first_line = 1)
      : text_(text),
        end_(text.data() + text.size()),
        file_(file),
        separator_(separator),
        first_line_(first_line) {}

  [[nodiscard]] const char* skip_blanks(const char* p) const {
    while (p != end_ && (*p == ' ' || (*p == '\t' && separator_ != '\t'))) ++p;
    return p;
  }

  /// Of blanks behind a cell, which are separators themselves where blanks separate.
  [[nodiscard]] const char* skip_blanks_behind(const char* p) const {
    return separator_ == ' ' ? p : skip_blanks(p);
  }

  [[nodiscard]] bool at_line_end(const char* p) const {
    return p == end_ || *p == '\n' || (*p == '\r' && (p + 1 == end_ || p[1] == '\n'));
  }

  [[nodiscard]] bool at_cell_end(const char* p) const {
    return p == end_ || *p == separator_ || at_line_end(p);
  }

  [[nodiscard]] const char* skip_line_end(const char* p) const {
    if (p != end_ && *p == '\r') ++p;
    if (p != end_ && *p == '\n') ++p;
    return p;
  }

  /// Whether there is nothing but blanks or a comment in the line at `p`, which then goes to the
  /// next one. @param comments  gets the comment, without `#` and outer blanks.
  [[nodiscard]] bool skip_blank_or_comment(const char*& p,
                                           std::vector<std::string>& comments) const;

  /// Between blanks, numbers without one between them are cells of their own (first_of_joined()).
  [[nodiscard]] RawCell scan(const char* p) const {
    p = skip_blanks(p);
    return p != end_ && *p == '"' ? scan_quoted(p) : scan_plain(p);
  }

  /// Where the next cell may begin, behind one that ends at `next`, not at the end of the line.
  [[nodiscard]] const char* behind(const char* next) const {
    return *next == separator_ ? next + 1 : next;
  }

  [[nodiscard]] TextPlace place(const char* p) const;

 private:
  [[nodiscard]] RawCell scan_plain(const char* begin) const;
  [[nodiscard]] RawCell scan_quoted(const char* open) const;
  void check_printable(const char* p) const;

  std::string_view text_;
  const char* end_;
  std::string_view file_;
  char separator_;
  std::size_t first_line_;
};

}  // namespace microslip
