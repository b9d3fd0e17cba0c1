// SPDX-License-Identifier: MIT
#include "microslip/io/cells/csv_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "microslip/io/bytes/text.hpp"

namespace microslip {

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> parse_comma_number(std::string_view text) {
  constexpr std::size_t kLongestNumber = 400;
  if (text.size() > kLongestNumber || text.find('.') != std::string_view::npos) return std::nullopt;
  std::string copy(text);
  const std::size_t comma = copy.find(',');
  if (comma != std::string::npos) copy[comma] = '.';
  return parse_number(copy);
}

std::optional<double> parse_grouped_number(std::string_view text, char decimal) {
  const char group = decimal == '.' ? ',' : '.';
  const std::size_t mark = text.rfind(decimal);
  if (mark == std::string_view::npos || text.find(group) == std::string_view::npos) return {};
  std::string number(text.substr(0, mark));
  std::size_t end = number.size();
  for (std::size_t at = number.rfind(group); at != number.npos; at = number.rfind(group)) {
    constexpr std::size_t kGroup = 4;  // with its mark
    if (end - at != kGroup || at == 0 || number[at - 1] < '0' || number[at - 1] > '9') return {};
    number.erase(at, 1);
    end = at;
  }
  number += '.';
  number += text.substr(mark + 1);
  return parse_number(number);
}

std::optional<double> parse_fortran_number(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  constexpr std::size_t kDigitsAlone = 3;
  const std::size_t point = text.find('.');
  if (text.size() > kLongest || point == std::string_view::npos) return std::nullopt;
  const std::size_t end = text.find_first_not_of("0123456789", point + 1);
  if (end == std::string_view::npos) return std::nullopt;
  const bool has_letter = text[end] == 'D' || text[end] == 'd';
  const std::string_view exponent = text.substr(has_letter ? end + 1 : end);
  const bool has_sign = exponent.starts_with('+') || exponent.starts_with('-');
  const std::string_view digits = exponent.substr(has_sign ? 1 : 0);
  const bool fits = has_letter || (has_sign && digits.size() == kDigitsAlone);
  if (!fits || digits.find_first_not_of("0123456789") != digits.npos) return std::nullopt;
  std::string number(text.substr(0, end));
  number += 'e';
  number += exponent;
  return parse_number(number);
}

namespace {

/// The length of the number that a text begins with: a decimal point and an exponent with its
/// letter, or with a sign and three digits that no point follows. 0 where there is none.
std::size_t fortran_length(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  const auto behind_digits = [&](std::size_t at) {
    return std::min(text.find_first_not_of(kDigits, at), text.size());
  };
  std::size_t at = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t whole = behind_digits(at);
  if (whole == text.size() || text[whole] != '.') return 0;
  const std::size_t fraction = behind_digits(whole + 1);
  if (fraction - at < 2) return 0;  // the point alone
  at = fraction;
  const bool letter = at < text.size() && std::string_view("EeDd").find(text[at]) != text.npos;
  if (letter) ++at;
  const bool sign = at < text.size() && (text[at] == '-' || text[at] == '+');
  const std::size_t end = behind_digits(at + (sign ? 1 : 0));
  if (letter) return end;
  const bool exponent = sign && end - at == 4 && (end == text.size() || text[end] != '.');
  return exponent ? end : fraction;
}

}  // namespace

std::string_view first_of_joined(std::string_view text) {
  const std::size_t first = fortran_length(text);
  if (first == 0 || first == text.size()) return {};
  for (std::size_t at = first; at < text.size();) {
    const std::size_t length = fortran_length(text.substr(at));
    if (length == 0 || (text[at] != '-' && text[at] != '+')) return {};
    at += length;
  }
  return text.substr(0, first);
}

char find_separator(std::string_view header, char otherwise) {
  bool in_quotes = false;
  std::string outside;
  for (const char c : trimmed(header)) {
    if (c == '"') in_quotes = !in_quotes;
    if (!in_quotes && c != ' ') outside += c;
  }
  if (outside.find(';') != std::string::npos) return ';';
  for (std::size_t at = outside.find('\t'); at < outside.size(); at = outside.find('\t', at + 1)) {
    const bool aligns = (at > 0 && outside[at - 1] == ',') || outside[at + 1] == ',';
    if (!aligns) return '\t';
  }
  return outside.find(',') == std::string::npos ? otherwise : ',';
}

bool continues_cell(std::string_view cell, std::string_view word) {
  const std::size_t open = cell.find_first_of("[(");
  const bool has_brackets = open != cell.npos;
  if (has_brackets && cell.find_first_of("])", open) == cell.npos) return true;
  return !cell.empty() && open != 0 && word.find_first_of("[(") == 0;
}

std::string separator_name(char separator) {
  return separator == '\t' ? "a tab" : in_quotes({&separator, 1});
}

FormatError ragged_row(const TextPlace& row, std::size_t columns, std::size_t cells,
                       char separator) {
  std::string remedy(kRemedyForDecimalCommas);
  if (columns == 1) {
    remedy =
        "Decimal commas need ';' or tabs between the columns; lines above the header begin with "
        "'#'.";
  } else if (separator == ' ' && cells < columns) {
    remedy = "Blanks separate the columns of this table: write nan for a value that is missing.";
  } else if (cells == 1 || separator != ',') {
    remedy = fmt::format("The separator of this table is {}.", separator_name(separator));
  }
  return {row, fmt::format("{} cell{} as in the header", columns, columns == 1 ? "" : "s"),
          fmt::format("{}", cells), remedy};
}

namespace {

/// 12/03/2024, 2024-03-12, 12.Mar, Mar-12; also of German spreadsheets.
bool looks_like_date(std::string_view cell) {
  constexpr std::size_t kLongest = 20;
  constexpr std::string_view kOfDates = "0123456789./-";
  if (cell.size() > kLongest || cell.find_first_of("0123456789") == cell.npos) return false;
  if (cell.find_first_not_of(kOfDates) == cell.npos) {
    // Two numbers between which there is no blank have a point and a sign.
    return std::ranges::count_if(std::string_view("./-"),
                                 [&](char mark) { return cell.find(mark) != cell.npos; }) == 1;
  }
  std::string month;
  for (const char c : cell) {
    if (kOfDates.find(c) == kOfDates.npos) month += static_cast<char>(c | 0x20);
  }
  constexpr std::string_view kMonths =
      " jan feb mar apr may jun jul aug sep oct nov dec mrz mai okt dez ";
  return month.size() == 3 && kMonths.find(month) != kMonths.npos;
}

}  // namespace

std::string_view remedy_for_cell(std::string_view cell) {
  if (cell.find_first_of("0123456789") < cell.find(':') && cell.find(':') != cell.npos) {
    return "Write times in seconds, from the start.";
  }
  return looks_like_date(cell) ? "It looks like a date, as spreadsheets make of numbers: format "
                                 "the column as numbers."
                               : "Correct the cell or remove the row.";
}

namespace {

/// Before a text that a spreadsheet would take for a formula.
constexpr char kFormulaGuard = '\'';

/// Whether a spreadsheet would compute the text, by its first character; numbers it may.
bool is_formula(std::string_view cell) {
  return cell.size() > 1 && std::string_view("=+-@").find(cell.front()) != cell.npos &&
         !parse_number(cell);
}

std::string_view without_guards(std::string_view cell) {
  return cell.substr(std::min(cell.find_first_not_of(kFormulaGuard), cell.size()));
}

}  // namespace

std::string unescaped(const RawCell& cell) {
  std::string text(cell.view());
  if (cell.quoted) {
    for (std::size_t i = text.find("\"\""); i != std::string::npos; i = text.find("\"\"", i + 1)) {
      text.erase(i, 1);
    }
  }
  if (text.starts_with(kFormulaGuard) && is_formula(without_guards(text))) text.erase(0, 1);
  return text;
}

std::optional<CsvColumn> parse_column(std::string_view text, bool parentheses) {
  const std::string_view cell = trimmed(text);
  std::size_t open = cell.find('[');
  char close = ']';
  if (open == std::string_view::npos && parentheses && cell.ends_with(')')) {
    open = cell.rfind('(');
    close = ')';
  }
  CsvColumn column{.name = std::string(trimmed(cell.substr(0, open))), .unit = {}};
  if (open == std::string_view::npos) return column;
  if (!cell.ends_with(close)) return std::nullopt;
  column.unit = trimmed(cell.substr(open + 1, cell.size() - open - 2));
  return column;
}

std::string on_one_line(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  return printable(result);
}

void append_comment(std::string& text, std::string_view comment) {
  for (;;) {
    const std::size_t end = comment.find('\n');
    const std::string line = on_one_line(comment.substr(0, end));
    text += line.empty() ? "#\n" : fmt::format("# {}\n", line);
    if (end == std::string_view::npos) return;
    comment.remove_prefix(end + 1);
  }
}

void check_column_name(std::string_view name) {
  if (name.empty() || name.find_first_of("[],;\"#\t\r\n") != std::string_view::npos) {
    throw InputError("column name", in_quotes(name), "must be text without [ ] , ; \" # and tabs");
  }
}

void append_text_cell(std::string& text, std::string_view cell) {
  std::string guarded;
  if (is_formula(without_guards(cell))) {
    guarded = kFormulaGuard + std::string(cell);
    cell = guarded;
  }
  const bool plain = !cell.empty() && cell.find_first_of(",;\"#") == std::string_view::npos &&
                     trimmed(cell).size() == cell.size() && !cell.starts_with(kByteOrderMark);
  if (plain) {
    text += cell;
    return;
  }
  text += '"';
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  text += '"';
}

bool CellScanner::skip_blank_or_comment(const char*& p, std::vector<std::string>& comments) const {
  const char* at = p;
  while (at != end_ && (*at == ' ' || *at == '\t')) ++at;
  if (at != end_ && *at == '#') {
    const std::string_view rest = text_.substr(static_cast<std::size_t>(at - text_.data()) + 1);
    std::string_view comment = rest.substr(0, rest.find('\n'));
    at = comment.data() + comment.size();
    if (comment.ends_with('\r')) comment.remove_suffix(1);
    comments.emplace_back(trimmed(comment));
  }
  if (!at_line_end(at)) return false;
  p = skip_line_end(at);
  return true;
}

TextPlace CellScanner::place(const char* p) const {
  TextPlace place = place_at(text_, static_cast<std::size_t>(p - text_.data()), file_);
  place.line += first_line_ - 1;
  return place;
}

RawCell CellScanner::scan_plain(const char* begin) const {
  const char* p = begin;
  for (; !at_cell_end(p); ++p) check_printable(p);
  const char* end = p;
  while (end != begin && (end[-1] == ' ' || end[-1] == '\t')) --end;
  if (separator_ == ' ') {
    const std::string_view first = first_of_joined({begin, static_cast<std::size_t>(end - begin)});
    if (!first.empty()) end = p = begin + first.size();
  }
  return {begin, end, p, false};
}

RawCell CellScanner::scan_quoted(const char* open) const {
  const char* p = open + 1;
  while (!at_line_end(p) && (*p != '"' || (p + 1 != end_ && p[1] == '"'))) {
    check_printable(p);
    p += *p == '"' ? 2 : 1;
  }
  if (at_line_end(p)) {
    throw FormatError(place(open), "a closing quote on the line of the opening one",
                      "the end of the line", "Close the quote or remove it.");
  }
  const char* next = skip_blanks_behind(p + 1);
  if (!at_cell_end(next)) {
    throw FormatError(place(next), "a separator after the closing quote", in_quotes({next, 1}),
                      "Double the quotes that belong to the text.");
  }
  return {open + 1, p, next, true};
}

void CellScanner::check_printable(const char* p) const {
  const auto byte = static_cast<unsigned char>(*p);
  if ((byte >= 0x20 && byte != 0x7F) || byte == '\t') return;
  throw FormatError(
      place(p), "text", fmt::format("the byte 0x{:02X}", byte),
      byte == '\r' ? "Save the table with line breaks LF or CRLF." : "Is this a text table?");
}

}  // namespace microslip
