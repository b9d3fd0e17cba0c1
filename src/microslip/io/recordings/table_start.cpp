// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/table_start.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "microslip/base/units.hpp"
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
};

/// Those that are not finite count: they stand in rows.
bool is_number_cell(std::string_view cell) {
  std::string capitals = in_capitals(cell);
  if (capitals.starts_with('+') || capitals.starts_with('-')) capitals.erase(0, 1);
  return parse_number(cell) || parse_comma_number(cell) || capitals == "NAN" || capitals == "INF";
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

/// Whether the line is a row of numbers with nothing but blanks between them.
bool split_by_blanks(TableLine& line) {
  if (line.text.find_first_of(",;\t\"") != std::string_view::npos) return false;
  std::vector<std::string_view> words = words_of(line.text);
  if (words.size() < 2 || !std::ranges::all_of(words, is_number_cell)) return false;
  line.cells = std::move(words);
  line.numbers = line.cells.size();
  line.blanks = true;
  return true;
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
    line.cells.push_back(trimmed(line.text.substr(begin, i - begin)));
    begin = i + 1;
  }
  if (line.cells.size() > 1 && line.cells.back().empty()) line.cells.pop_back();
  line.numbers = static_cast<std::size_t>(std::ranges::count_if(line.cells, is_number_cell));
}

/// Lines that are neither blank nor comments.
std::vector<TableLine> lines_of(std::string_view text) {
  std::vector<TableLine> lines;
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
    }
    at = end + 1;
  }
  return lines;
}

/// At least half of its cells are numbers; dates, remarks and empty cells may stand among them.
bool is_row(const TableLine& line) {
  return line.numbers > 0 && 2 * line.numbers >= line.cells.size();
}

bool is_unit_cell(std::string_view cell) {
  const bool brackets = cell.size() > 1 && (cell.front() == '[' || cell.front() == '(');
  return brackets || find_unit(cell) || is_other_unit(cell);
}

bool names_time(std::string_view cell) {
  return axis_dimension(trimmed(cell.substr(0, cell.find_first_of("[(")))).has_value();
}

/// Whether a line below that of the names has their units. Names may look like units, as t and N
/// do, and a unit may be unknown: then a time among the names tells.
bool is_unit_line(const TableLine& line, const TableLine& names) {
  const auto is_unit_or_empty = [](auto cell) { return cell.empty() || is_unit_cell(cell); };
  if (!std::ranges::any_of(line.cells, is_unit_cell)) return false;
  return std::ranges::all_of(line.cells, is_unit_or_empty) ||
         std::ranges::any_of(names.cells, names_time);
}

bool is_header(const TableLine& line, std::size_t columns) {
  return line.cells.size() == columns && line.numbers == 0;
}

/// The line as one of a table like that of a row.
TableLine as_in_table_of(const TableLine& row, const TableLine& line) {
  if (!row.blanks || find_separator(line.text, ' ') != ' ') return line;
  return {.text = line.text,
          .offset = line.offset,
          .cells = words_of(line.text),
          .numbers = line.numbers,
          .blanks = true};
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

}  // namespace

TableStart find_table_start(std::string_view text) {
  const std::vector<TableLine> lines = lines_of(text);
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    const std::size_t columns = lines[i].cells.size();
    if (!is_row(lines[i]) || !is_row(lines[i + 1]) || lines[i + 1].cells.size() != columns)
      continue;
    const TableLine last = as_in_table_of(lines[i], lines[i - 1]);
    if (!is_header(last, columns)) continue;
    const TableLine above = i > 1 ? as_in_table_of(lines[i], lines[i - 2]) : TableLine{};
    const bool units = is_header(above, columns) && is_unit_line(last, above);
    const std::size_t header = units ? i - 2 : i - 1;
    const auto has_time = [](const TableLine& l) {
      return std::ranges::any_of(l.cells, names_time);
    };
    if (has_time(lines[0]) && !has_time(units ? above : last))
      break;  // the first line is the header
    TableStart start{{},
                     lines[header].offset,
                     lines[header].text,
                     lines[header + 1].text,
                     lines[i].blanks,
                     counts_rows(lines, i)};
    for (std::size_t k = 0; k < header; ++k) start.preamble.push_back(lines[k].text);
    return start;
  }
  if (lines.size() < 2) return {};
  return {{}, lines[0].offset, lines[0].text, lines[1].text};
}

}  // namespace microslip
