// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/table_start.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/character_set.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/recordings/assumed_units.hpp"

namespace microslip {
namespace {

/// More lines than any logger writes above its table.
constexpr std::size_t kMostLines = 1000;

struct TableLine {
  std::string_view text;
  std::size_t offset = 0;
  std::vector<std::string_view> cells = {};
  std::size_t numbers = 0;  ///< of the cells
  bool blanks = false;      ///< whether they are numbers with nothing but blanks between them
  bool gaps = false;        ///< whether two blanks or more separate its cells
};

std::optional<double> number_in(std::string_view cell) {
  std::optional<double> number = parse_number(cell);
  if (!number) number = parse_comma_number(cell);
  if (!number) number = parse_grouped_number(cell, ',');
  if (!number) number = parse_grouped_number(cell, '.');
  return number ? number : parse_fortran_number(cell);
}

/// Those that are not finite count: they stand in rows.
bool is_number_cell(std::string_view cell) {
  std::string capitals = in_capitals(cell);
  if (capitals.starts_with('+') || capitals.starts_with('-')) capitals.erase(0, 1);
  return number_in(cell) || capitals == "NAN" || capitals == "INF";
}

/// The cells of a line between blanks; blanks may stand in quotes, within and before brackets.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(' '); at < text.size();) {
    const bool quoted = text[at] == '"';
    if (quoted) ++at;
    const std::size_t end = std::min(text.find(quoted ? '"' : ' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    if (!words.empty() && continues_cell(words.back(), word)) {
      const char* const begin = words.back().data();
      words.back() = {begin, static_cast<std::size_t>(text.data() + end - begin)};
    } else {
      words.push_back(word);
    }
    at = text.find_first_not_of(' ', end + (quoted ? 1 : 0));
  }
  return words;
}

/// Words of which numbers in columns of fixed width, without blanks between them, are apart.
std::vector<std::string_view> words_apart(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::string_view word : words_of(text)) {
    for (auto first = first_of_joined(word); !first.empty(); first = first_of_joined(word)) {
      words.push_back(first);
      word.remove_prefix(first.size());
    }
    words.push_back(word);
  }
  return words;
}

/// Whether the line is a row of numbers, two at least, with nothing but blanks between them, and
/// not more words of text than numbers. The first may be in quotes, as the names of rows are.
bool split_by_blanks(TableLine& line) {
  if (line.text.find_first_of(",;\t") != std::string_view::npos) return false;
  std::vector<std::string_view> words = words_apart(line.text);
  const auto numbers = static_cast<std::size_t>(std::ranges::count_if(words, is_number_cell));
  if (numbers < 2 || 2 * numbers < words.size()) return false;
  line.cells = std::move(words);
  line.numbers = numbers;
  line.blanks = true;
  return true;
}

std::string_view without_quotes(std::string_view cell) {
  const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

void split(TableLine& line) {
  if (split_by_blanks(line)) return;
  const char separator = find_separator(line.text);
  bool in_quotes = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.text.size(); ++i) {
    const bool end = i == line.text.size();
    if (!end && line.text[i] == '"') in_quotes = !in_quotes;
    if (!end && (in_quotes || line.text[i] != separator)) continue;
    line.cells.push_back(without_quotes(trimmed(line.text.substr(begin, i - begin))));
    begin = i + 1;
  }
  if (line.cells.size() > 1 && line.cells.back().empty()) line.cells.pop_back();
  line.numbers = static_cast<std::size_t>(std::ranges::count_if(line.cells, is_number_cell));
}

/// The beginning of a text.
struct TableLines {
  std::vector<TableLine> lines = {};  ///< neither blank nor comments
  TableLine comment = {};             ///< the last one above them, without its mark
};

TableLines lines_of(std::string_view text) {
  TableLines found;
  std::vector<TableLine>& lines = found.lines;
  const std::size_t start = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  for (std::size_t at = start; at < text.size() && lines.size() < kMostLines;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string_view inside = trimmed(line);
    const bool comment =
        inside.starts_with("//") || inside.starts_with('#') || inside.starts_with('%');
    if (!inside.empty() && !comment) {
      lines.push_back({line, at});
      split(lines.back());
    } else if (comment && lines.empty()) {
      found.comment = {inside.substr(inside.starts_with("//") ? 2 : 1), at};
      split(found.comment);
    }
    at = end + 1;
  }
  return found;
}

/// At least half of its cells are numbers; dates, remarks and empty cells may stand among them.
bool is_row(const TableLine& line) {
  return line.numbers > 0 && 2 * line.numbers >= line.cells.size();
}

/// A name and a value, as programs write them above a table.
bool is_pair(const TableLine& line) {
  return line.cells.size() == 2 && line.numbers == 1 && !number_in(line.cells.front()) &&
         line.cells.front().find_first_of("0123456789") == std::string_view::npos;
}

bool is_whole_row(const TableLine& line) {
  return line.cells.size() > 1 && line.numbers == line.cells.size();
}

/// In any character set.
bool is_unit_cell(std::string_view cell) {
  const bool brackets = cell.size() > 1 && (cell.front() == '[' || cell.front() == '(');
  const std::string text = to_utf8(std::string(cell));
  return brackets || find_unit(text) || is_other_unit(text);
}

bool names_time(std::string_view cell) {
  return axis_dimension(trimmed(cell.substr(0, cell.find_first_of("[(")))).has_value();
}

/// Of time or frequency, and no name of them as t and f are.
bool is_axis_unit(std::string_view cell) {
  const std::optional<Unit> unit = find_unit(to_utf8(std::string(cell)));
  return unit && (unit->dimension == kTime || unit->dimension == kFrequency) && !names_time(cell);
}

/// Whether a line below that of the names has their units. Names may look like units, as t and N
/// do, and a unit may be unknown: then a time among the names tells, or a unit of time among units.
bool is_unit_line(const TableLine& line, const TableLine& names) {
  const auto is_unit_or_empty = [](auto cell) { return cell.empty() || is_unit_cell(cell); };
  const auto units = static_cast<std::size_t>(std::ranges::count_if(line.cells, is_unit_cell));
  if (units == 0) return false;
  return std::ranges::all_of(line.cells, is_unit_or_empty) ||
         std::ranges::any_of(names.cells, names_time) ||
         (2 * units > line.cells.size() && std::ranges::any_of(line.cells, is_axis_unit));
}

bool is_header(const TableLine& line, std::size_t columns) {
  return line.cells.size() == columns && line.numbers == 0;
}

/// Whether a name stands before the numbers of channels, as an oscilloscope writes them above their
/// units: `x-axis,1,2`.
bool is_numbered_header(const TableLine& line, const TableLine& units) {
  const auto is_channel_number = [](std::string_view cell) {
    constexpr std::size_t kMostDigits = 2;
    return !cell.empty() && cell.size() <= kMostDigits &&
           cell.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t columns = units.cells.size();
  return columns > 1 && line.cells.size() == columns && !line.cells[0].empty() &&
         line.numbers == columns - 1 && is_axis_unit(units.cells[0]) &&
         std::all_of(line.cells.begin() + 1, line.cells.end(), is_channel_number);
}

/// The cells of a line between two blanks or more.
std::vector<std::string_view> gapped_cells(std::string_view text) {
  std::vector<std::string_view> cells;
  text = trimmed(text);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("  "), text.size());
    cells.push_back(text.substr(0, end));
    text = trimmed(text.substr(end));
  }
  return cells;
}

/// The line as one of a table like that of a row; names of several words may have more than one
/// blank between them.
TableLine as_in_table_of(const TableLine& row, const TableLine& line) {
  if (!row.blanks || find_separator(line.text, ' ') != ' ') return line;
  TableLine split{.text = line.text,
                  .offset = line.offset,
                  .cells = words_of(line.text),
                  .numbers = line.numbers,
                  .blanks = true};
  std::vector<std::string_view> gapped = gapped_cells(line.text);
  split.gaps = split.cells.size() != gapped.size() && gapped.size() == row.cells.size() &&
               line.text.find('"') == std::string_view::npos;
  if (split.gaps) split.cells = std::move(gapped);
  return split;
}

/// Which columns rise in the rows from `first` on, as far as they are seen.
std::vector<bool> rising_columns(const std::vector<TableLine>& lines, std::size_t first) {
  if (first >= lines.size()) return {};
  const std::size_t columns = lines[first].cells.size();
  std::vector<bool> rising(columns, true);
  std::vector<double> last(columns, -std::numeric_limits<double>::infinity());
  for (std::size_t i = first; i < lines.size() && lines[i].cells.size() == columns; ++i) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::optional<double> number = number_in(lines[i].cells[column]);
      rising[column] = rising[column] && number && *number > last[column];
      last[column] = number.value_or(last[column]);
    }
  }
  return rising;
}

/// Whether the first cells of the rows from `first` on are 0, 1, 2, … or 1, 2, 3, …
bool counts_rows(const std::vector<TableLine>& lines, std::size_t first) {
  constexpr std::size_t kEnough = 3;
  const std::size_t rows = std::min(kEnough, lines.size() - first);
  const std::string_view start = lines[first].cells.front();
  if (start != "0" && start != "1") return false;
  for (std::size_t i = 1; i < rows; ++i) {
    const std::size_t number = i + (start == "1" ? 1 : 0);
    if (lines[first + i].cells.front() != std::to_string(number)) return false;
  }
  return true;
}

std::vector<std::string> texts_of(const TableLine& row) {
  std::vector<std::string> texts;
  for (const std::string_view cell : row.cells) {
    texts.emplace_back(is_number_cell(cell) ? std::string_view() : cell);
  }
  return texts;
}

/// Where names stand in a comment above rows of numbers, or there are none.
std::optional<TableStart> start_without_header(const TableLines& found) {
  const std::vector<TableLine>& lines = found.lines;
  const bool numbers = lines.size() > 1 && is_whole_row(lines[0]) && is_whole_row(lines[1]) &&
                       lines[0].cells.size() == lines[1].cells.size();
  if (!numbers) return std::nullopt;
  TableStart start{.preamble = {},
                   .header = lines[0].offset,
                   .names = lines[0].text,
                   .below = lines[1].text,
                   .blanks = lines[0].blanks};
  const TableLine comment = as_in_table_of(lines[0], found.comment);
  const bool names = is_header(comment, lines[0].cells.size()) &&
                     std::ranges::none_of(comment.cells, is_number_cell);
  if (names) start.commented = comment.text;
  start.gaps = names && comment.gaps;
  start.rising = rising_columns(lines, 0);
  return start;
}

/// Where the header is that `last`, the line above the rows from `first` on, ends.
struct HeaderLines {
  std::size_t names;
  bool has_units = false;
  bool gaps = false;
};

/// One line may stand between names and units, such as that of the rates of channels.
HeaderLines header_above(const std::vector<TableLine>& lines, std::size_t first,
                         const TableLine& last) {
  const std::size_t columns = lines[first].cells.size();
  constexpr std::size_t kMostBetween = 1;
  for (std::size_t between = 0; between <= kMostBetween && between + 1 < first; ++between) {
    const std::size_t names = first - 2 - between;
    const TableLine above = as_in_table_of(lines[first], lines[names]);
    const bool may_be_apart = between == 0 || std::ranges::any_of(last.cells, is_axis_unit);
    const bool is_above =
        is_header(above, columns) || (between == 0 && is_numbered_header(above, last));
    if (is_above && may_be_apart && is_unit_line(last, above)) return {names, true, above.gaps};
    if (is_header(above, columns)) break;
  }
  return {first - 1, false, last.gaps};
}

/// Whether a first line with numbers stands over lines of the same kind: text over text.
bool is_row_beside_text(const TableLine& first, const TableLine& next) {
  if (!is_row(first) || is_pair(first) || first.cells.size() != next.cells.size()) return false;
  for (std::size_t i = 0; i < first.cells.size(); ++i) {
    const auto is_text = [&](const TableLine& line) {
      return !line.cells[i].empty() && !is_number_cell(line.cells[i]);
    };
    if (is_text(first) && is_text(next)) return true;
  }
  return false;
}

/// The rows of numbers where the first line cannot have their names. One directly above rows is
/// taken for their header, whatever it has.
std::optional<UnnamedRows> unnamed_rows(const std::vector<TableLine>& lines,
                                        std::string_view text) {
  if (std::ranges::any_of(lines[0].cells, names_time)) return std::nullopt;
  const auto rows = [&](std::size_t first) {
    const std::string_view above = text.substr(0, lines[first].offset);
    return UnnamedRows{1 + static_cast<std::size_t>(std::ranges::count(above, '\n')),
                       lines[first].cells.size()};
  };
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    const std::size_t columns = lines[i].cells.size();
    if (!is_whole_row(lines[i]) || !is_whole_row(lines[i + 1])) continue;
    if (lines[i + 1].cells.size() != columns) continue;
    const bool fits = as_in_table_of(lines[i], lines[0]).cells.size() == columns;
    return i == 1 || fits ? std::nullopt : std::optional(rows(i));
  }
  return is_row_beside_text(lines[0], lines[1]) ? std::optional(rows(0)) : std::nullopt;
}

}  // namespace

TableStart find_table_start(std::string_view text) {
  const TableLines found = lines_of(text);
  const std::vector<TableLine>& lines = found.lines;
  if (auto start = start_without_header(found)) return *std::move(start);
  const auto has_time = [](const TableLine& line) {
    return std::ranges::any_of(line.cells, names_time);
  };
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    const std::size_t columns = lines[i].cells.size();
    if (!is_row(lines[i]) || !is_row(lines[i + 1]) || lines[i + 1].cells.size() != columns)
      continue;
    const bool pairs = is_pair(lines[i]) && is_pair(lines[i + 1]);
    if (pairs &&
        std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(i), lines.end(), is_whole_row)) {
      continue;
    }
    const TableLine last = as_in_table_of(lines[i], lines[i - 1]);
    const bool row_names =
        lines[i].blanks && is_header(last, columns - 1) && trimmed(lines[i].text).starts_with('"');
    if (!is_header(last, columns) && !row_names) continue;
    const HeaderLines header = header_above(lines, i, last);
    const TableLine names = as_in_table_of(lines[i], lines[header.names]);
    if (has_time(lines[0]) && !has_time(names)) break;  // the first line is the header
    TableStart start{.preamble = {},
                     .header = lines[header.names].offset,
                     .units = header.has_units ? lines[i - 1].offset : 0,
                     .names = lines[header.names].text,
                     .below = header.has_units ? lines[i - 1].text : lines[i].text,
                     .blanks = lines[i].blanks,
                     .counts = counts_rows(lines, i),
                     .gaps = header.gaps,
                     .row_names = row_names};
    for (std::size_t k = 0; k < header.names; ++k) start.preamble.push_back(lines[k].text);
    start.rising = rising_columns(lines, i);
    start.texts = texts_of(lines[i]);
    return start;
  }
  if (lines.size() < 2) return {};
  TableStart start{.preamble = {},
                   .header = lines[0].offset,
                   .names = lines[0].text,
                   .below = lines[1].text,
                   .unnamed = unnamed_rows(lines, text)};
  const auto row = std::ranges::find_if(lines.begin() + 1, lines.end(), is_row);
  start.rising = rising_columns(lines, static_cast<std::size_t>(row - lines.begin()));
  if (row != lines.end()) start.texts = texts_of(*row);
  return start;
}

}  // namespace microslip
