// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/recording_csv_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "microslip/io/bytes/character_set.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/recordings/doubtful_unit.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

constexpr std::string_view kExampleRecordingHeader = "'time [s],force [N],acc1 [m/s^2]'";
constexpr std::string_view kUsualUnits = "s, Hz, N, m/s^2, g, m/s, m, um (µm), 1";

/// In small letters, with _ for blanks.
std::string plain_name(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == ' ') c = '_';
  }
  return name;
}

/// Name and value of a comment that has the form of an attribute.
std::optional<std::pair<std::string_view, std::string_view>> split_attribute(
    std::string_view text) {
  const std::size_t sign = text.find_first_of(":=");
  if (sign == std::string_view::npos) return std::nullopt;
  const std::string_view name = trimmed(text.substr(0, sign));
  const std::string_view value = text.substr(sign + 1);
  // A colon without a blank behind it is part of a time of day or an address.
  const bool spaced = text[sign] == '=' || value.empty() || value.front() == ' ';
  if (name.empty() || !spaced) return std::nullopt;
  return std::pair{name, trimmed(value)};
}

/// A number, in Hz or with a unit of frequency behind it.
std::optional<double> parse_rate(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const std::string_view unit_text = trimmed(text);
  const std::optional<Unit> unit =
      unit_text.empty() ? Unit{.dimension = kFrequency} : find_unit(unit_text);
  if (!unit || unit->dimension != kFrequency) return std::nullopt;
  const double rate = unit->to_si(value);
  return rate > 0.0 && std::isfinite(rate) ? std::optional(rate) : std::nullopt;
}

bool is_rate_name(std::string_view name) {
  return std::ranges::any_of(
      kRateNames, [&](const char* known) { return plain_name(known) == plain_name(name); });
}

bool is_bracketed(std::string_view text) {
  return text.size() > 1 && ((text.front() == '[' && text.back() == ']') ||
                             (text.front() == '(' && text.back() == ')'));
}

std::string_view without_brackets(std::string_view text) {
  return is_bracketed(text) ? trimmed(text.substr(1, text.size() - 2)) : text;
}

/// A line of several columns with nothing but blanks between them.
void check_separator(std::string_view text, const TextPlace& place) {
  const std::size_t close = text.find_first_of("])");
  const bool goes_on = close != std::string_view::npos && !trimmed(text.substr(close + 1)).empty();
  if (!goes_on && trimmed(text).find("  ") == std::string_view::npos) return;
  throw FormatError(place, "columns separated by commas, semicolons or tabs",
                    fmt::format("blanks between them, {}", in_quotes(text)),
                    "Replace the blanks between columns by ';', in the header and in the rows, "
                    "but not those within a name, before or within its unit.");
}

/// Of names between two blanks or more.
std::string with_names_in_quotes(std::string_view line) {
  std::string quoted;
  for (line = trimmed(line); !line.empty();) {
    const std::size_t end = std::min(line.find("  "), line.size());
    quoted += fmt::format("{}\"{}\"", quoted.empty() ? "" : " ", line.substr(0, end));
    line = trimmed(line.substr(end));
  }
  return quoted;
}

/// The place of what begins behind `passed`, which begins at `known`.
TextPlace place_behind(const TextPlace& known, std::string_view passed) {
  TextPlace place = place_at(passed, passed.size(), known.file);
  if (place.line == 1) place.column += known.column - 1;
  place.line += known.line - 1;
  return place;
}

}  // namespace

void RecordingCsvHeader::add_comment(std::string_view text) {
  const std::string comment = to_utf8(trimmed(text));
  const auto attribute = split_attribute(comment);
  if (!attribute) {
    if (!comment.empty()) attributes_.emplace_back("comment", comment);
    return;
  }
  const auto& [name, value] = *attribute;
  attributes_.emplace_back(name, value);
  if (is_rate_name(name) && !rate_) rate_ = parse_rate(value);
}

std::vector<CsvColumn> RecordingCsvHeader::columns_as_written() const {
  std::vector<CsvColumn> columns;
  for (const Cell& cell : cells_) columns.push_back(cell.column);
  return columns;
}

void RecordingCsvHeader::add_preamble(std::string_view line) {
  const std::size_t last = line.find_last_not_of(";,\t\r ");
  std::string text(line.substr(0, last == std::string_view::npos ? 0 : last + 1));
  const std::size_t separator = text.find_first_of(";\t,");
  const bool pair = separator != std::string::npos && text.find_first_of(":=") >= separator;
  if (pair) text.replace(separator, 1, ": ");  // name and value in cells of their own
  std::erase(text, '"');
  add_comment(text);
}

std::vector<RecordingCsvHeader::Cell> RecordingCsvHeader::read_cells(std::string_view line,
                                                                     std::size_t number) const {
  const char separator = separator_ == ' ' ? find_separator(line, ' ') : separator_;
  const CellScanner scanner(line, file_, separator, number);
  std::vector<Cell> cells;
  const char* known = line.data();
  TextPlace place{.file = file_, .line = number, .column = 1};
  for (const char* p = line.data();;) {
    const RawCell raw = scanner.scan(p);
    place = place_behind(place, {known, raw.begin});
    known = raw.begin;
    const bool last = scanner.at_line_end(raw.next);
    const bool trailing = last && raw.begin == raw.end && !raw.quoted && !cells.empty();
    const std::string text = to_utf8(unescaped(raw));
    const bool joins = separator == ' ' && !trailing && !cells.empty() &&
                       continues_cell(cells.back().column.name, text);
    if (joins) {
      cells.back().column.name += " " + text;
    } else if (!trailing) {
      cells.push_back({.column = {.name = text, .unit = {}}, .place = place});
    }
    if (last) return cells;
    p = scanner.behind(raw.next);
  }
}

void RecordingCsvHeader::read_names(std::string_view line, std::size_t number,
                                    const TableStart& table) {
  separator_ = table.blanks ? ' ' : find_separator(line);
  cells_ = table.gaps ? read_cells(with_names_in_quotes(line), number) : read_cells(line, number);
  const auto is_number = [](const Cell& cell) {
    return parse_number(cell.column.name) || parse_comma_number(cell.column.name);
  };
  if (std::ranges::all_of(cells_, is_number)) {
    throw FormatError(cells_.front().place,
                      fmt::format("a header such as {}", kExampleRecordingHeader),
                      "a row of numbers", "Add a first line that names each column with its unit.");
  }
  if (cells_.size() == 1) check_separator(cells_.front().column.name, cells_.front().place);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::string text = cells_[i].column.name;
    const std::optional<CsvColumn> column = parse_column(text, true);
    if (!column) {
      throw FormatError(cells_[i].place,
                        fmt::format("'name [unit]' as the header of column {}", i + 1),
                        in_quotes(text));
    }
    cells_[i].column = *column;
    if (column->name.empty()) cells_[i].column.name = fmt::format("column {}", i + 1);
  }
  keep_indices();
  // Who writes blanks between names that have some quotes them.
  words_ = separator_ == ' ' && find_separator(line, ' ') == ' ' && line.find('"') == line.npos &&
           !table.gaps;
  if (table.row_names) {
    cells_.insert(cells_.begin(), {{.name = "row", .unit = "1"}, cells_.front().place});
  }
}

/// `Y[0]` and `Y[1]` are channels of LabVIEW, not one without unit and one in 1: whole numbers in
/// brackets are indices where one of them is not 1. The names are Y_0 and Y_1, as brackets have
/// units.
void RecordingCsvHeader::keep_indices() {
  const auto is_index = [](const Cell& cell) {
    const std::optional<std::string>& unit = cell.column.unit;
    return unit && !unit->empty() && unit->find_first_not_of("0123456789") == std::string::npos;
  };
  const bool found = std::ranges::any_of(
      cells_, [&](const Cell& cell) { return is_index(cell) && cell.column.unit != "1"; });
  if (!found) return;
  for (Cell& cell : cells_) {
    if (!is_index(cell)) continue;
    cell.column.name += fmt::format("_{}", *cell.column.unit);
    cell.column.unit.reset();
  }
}

/// A name of two words over one column and a column without a name look as two names do. One over
/// text is a name of its own: it has no unit.
void RecordingCsvHeader::check_words(const TableStart& table) const {
  for (std::size_t i = 0; i + 1 < cells_.size(); ++i) {
    const bool over_text = i < table.texts.size() && !table.texts[i].empty();
    if (cells_[i].column.unit || over_text || !cells_[i + 1].column.unit) continue;
    throw FormatError(
        cells_[i].place, "a unit behind each name, for blanks separate them",
        fmt::format("{} without one before {}", in_quotes(cells_[i].column.name),
                    in_quotes(cells_[i + 1].column.name)),
        "Join words of one name by '_', name each column, and give those without unit a [1].");
  }
}

void RecordingCsvHeader::check_counted_rows() const {
  const auto has_unit = [](const Cell& cell) { return cell.column.unit.has_value(); };
  if (!words_ || axis_ != 0 || std::ranges::all_of(cells_, has_unit)) return;
  throw FormatError(
      cells_.front().place, "a unit behind each name, for blanks separate them",
      fmt::format("{} over 0, 1, 2 or 1, 2, 3, which may be numbers of rows", label(0)),
      "Name each column with its unit, [1] where it has none, and join words of one name by '_'.");
}

void RecordingCsvHeader::tell_names_apart(std::vector<Warning>& warnings) {
  std::map<std::string, std::vector<std::size_t>> columns;
  for (std::size_t i = 0; i < cells_.size(); ++i) columns[cells_[i].column.name].push_back(i);
  std::set<std::string> taken;
  for (const auto& [name, indices] : columns) {
    if (indices.size() == 1) taken.insert(name);
  }
  for (const auto& [name, indices] : columns) {
    for (std::size_t k = 0; indices.size() > 1 && k < indices.size(); ++k) {
      CsvColumn& column = cells_[indices[k]].column;
      const std::string by_unit = fmt::format("{} ({})", name, column.unit.value_or(""));
      const bool has_unit = column.unit && !column.unit->empty();
      if (has_unit && taken.insert(by_unit).second) {
        column.name = by_unit;
        continue;
      }
      if (k == 0 && taken.insert(name).second) continue;
      column.name = fmt::format("{} (column {})", name, indices[k] + 1);
      while (!taken.insert(column.name).second) column.name += '\'';
      warnings.push_back(
          {"columns_of_one_name",
           fmt::format("{}: columns {} and {} are both called {}; the latter is called {} here",
                       place_text(cells_[indices[k]].place), indices[0] + 1, indices[k] + 1,
                       in_quotes(name), in_quotes(column.name))});
    }
  }
}

bool RecordingCsvHeader::read_units(std::string_view line, std::size_t number) {
  const auto has_unit = [](const Cell& cell) { return cell.column.unit.has_value(); };
  if (std::ranges::any_of(cells_, has_unit)) return false;
  const std::vector<Cell> units = read_cells(line, number);
  bool known = false;
  for (const Cell& cell : units) {
    const std::string& text = cell.column.name;
    if (text != "1" && parse_number(text)) return false;
    known = known || is_bracketed(text) || (text != "1" && text != "-" && find_unit(text));
  }
  if (!known) return false;
  if (units.size() > cells_.size()) {
    throw ragged_row(units.front().place, cells_.size(), units.size(), separator_);
  }
  for (std::size_t i = 0; i < units.size(); ++i) {
    cells_[i].column.unit = without_brackets(units[i].column.name);
    cells_[i].place = units[i].place;
  }
  return true;
}

void RecordingCsvHeader::take_units_of_names(const AssumedUnits& assumed) {
  const std::vector<CsvColumn> columns = columns_as_written();
  unit_mark_ = unit_mark_of(columns);
  if (!unit_mark_) return;
  for (Cell& cell : cells_) {
    std::string& name = cell.column.name;
    if (cell.column.unit) {  // `v / (mm/s)`
      if (unit_mark_ == UnitMark::kSlash && name.ends_with('/')) name.pop_back();
      name = trimmed(name);
    } else if (auto split = split_unit_of_name(name, *unit_mark_)) {
      const bool is_assumed = unit_mark_ == UnitMark::kUnderscore && assumed.names(name);
      if (!is_assumed || stated_unit_of_time(*split->unit)) cell.column = *std::move(split);
    }
  }
}

/// Of those behind `_`, which may be part of a name.
void RecordingCsvHeader::warn_of_units_in_names(std::vector<Warning>& warnings) const {
  if (unit_mark_ != UnitMark::kUnderscore) return;
  std::string names;
  for (const Cell& cell : cells_) {
    if (!cell.column.unit) continue;
    names += fmt::format("{}{} in {}", names.empty() ? "" : ", ", in_quotes(cell.column.name),
                         *cell.column.unit);
  }
  warnings.push_back({"units_in_names", fmt::format("{}: units are taken from the ends of names: "
                                                    "{}. Where one is none, write 'name [unit]'",
                                                    file_, names)});
}

RecordingColumn RecordingCsvHeader::resolve_column(std::size_t i) const {
  const auto& [name, unit_text] = cells_[i].column;
  RecordingColumn column{.name = name, .unit = {}, .dimension = {}};
  if (!unit_text || unit_text->empty()) return column;
  if (const std::optional<Unit> unit = find_unit(*unit_text)) {
    column.unit = *unit;
    column.dimension = unit->dimension;
  } else {
    column.unknown_unit = *unit_text;
  }
  return column;
}

void RecordingCsvHeader::warn_of_unknown_units(std::vector<Warning>& warnings) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string& unit = columns_[i].unknown_unit;
    if (unit.empty() || is_other_unit(unit)) continue;
    warnings.push_back(
        {"unit_unknown",
         fmt::format("{}: column {} {} is in {}, an unknown unit; it is treated as without unit. "
                     "Usual units: {}",
                     place_text(cells_[i].place), i + 1, in_quotes(columns_[i].name),
                     in_quotes(unit), kUsualUnits)});
  }
}

/// With a rate in a comment, a frequency that does not rise is a channel like others, and so is a
/// column that may be a time but need not.
std::optional<AxisRank> RecordingCsvHeader::axis_rank(std::size_t i, const AssumedUnits& assumed,
                                                      const std::vector<bool>& rising) const {
  const RecordingColumn& column = columns_[i];
  std::optional<AxisRank> rank;
  if (column.dimension) {
    rank = rank_as_axis(column.name, column.unit);
  } else if (const std::optional<Dimension> named = axis_dimension(column.name)) {
    const bool known = column.unknown_unit.empty() ? assumed.find(column.name).has_value()
                                                   : assumed.names(column.name);
    rank = known                         ? rank_as_axis(column.name, Unit{.dimension = *named})
           : column.unknown_unit.empty() ? AxisRank::kWithoutUnit
                                         : AxisRank::kUnknownUnit;
  }
  const bool frequency =
      (column.dimension ? column.dimension : axis_dimension(column.name)) == kFrequency;
  const bool rises = i < rising.size() && rising[i];
  const bool channel =
      rank && (frequency ? !rises || *rank != AxisRank::kNamedFrequency : *rank >= AxisRank::kSpan);
  return rate_ && channel ? std::nullopt : rank;
}

/// The first one of the best rank.
std::optional<std::size_t> RecordingCsvHeader::find_axis(const AssumedUnits& assumed,
                                                         const std::vector<bool>& rising) const {
  std::optional<std::size_t> best;
  std::optional<AxisRank> of_best;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::optional<AxisRank> rank = axis_rank(i, assumed, rising);
    if (!rank || (of_best && *of_best <= *rank)) continue;
    best = i;
    of_best = rank;
  }
  return best;
}

void RecordingCsvHeader::prefer_frequency(const AssumedUnits& assumed,
                                          const std::vector<bool>& rising,
                                          std::vector<Warning>& warnings) {
  const RecordingColumn& time = columns_[*axis_];
  if (axis_rank(*axis_, assumed, rising) != AxisRank::kTimeUnit || is_named_as_time(time.name))
    return;
  const auto rises = [&](std::size_t i) { return i < rising.size() && rising[i]; };
  std::optional<std::size_t> frequency;
  std::size_t found = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].dimension != kFrequency || !rises(i)) continue;
    ++found;
    if (axis_rank(i, assumed, rising) == AxisRank::kNamedFrequency) frequency = i;
  }
  if (found != 1 || !frequency) return;
  if (rises(*axis_)) {
    warnings.push_back(
        {"axis_chosen",
         fmt::format("{}: {} is taken for the axis, though {} rises in a unit of time. Name the "
                     "latter 'time' where it is the axis",
                     place_text(cells_[*frequency].place), in_quotes(columns_[*frequency].name),
                     in_quotes(time.name))});
  }
  axis_ = frequency;
}

void RecordingCsvHeader::resolve(const RecordingReadOptions& options, const TableStart& table,
                                 std::vector<Warning>& warnings) {
  take_units_of_names(options.assumed_units);
  warn_of_units_in_names(warnings);
  if (words_) check_words(table);
  tell_names_apart(warnings);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    RecordingColumn& column = columns_.emplace_back(resolve_column(i));
    if (!column.dimension || !is_force_in_pounds(column.name, column.unit)) continue;
    column.unit = pound_force();
    column.dimension = column.unit.dimension;
    warnings.push_back(force_in_pounds(place_text(cells_[i].place), column.name));
  }
  if (options.no_axis) {
    rate_ = 1.0;
    untimed_ = true;
    return warn_of_unknown_units(warnings);
  }
  axis_ = find_axis(options.assumed_units, table.rising);
  if (axis_) prefer_frequency(options.assumed_units, table.rising, warnings);
  const bool may_be_text = axis_ && *axis_ < table.texts.size() && !columns_[*axis_].dimension;
  if (may_be_text && !table.texts[*axis_].empty()) {
    text_time_ = table.texts[*axis_];
    text_times_ = std::exchange(axis_, std::nullopt);
  }
  if (axis_) resolve_axis(options.assumed_units);
  warn_of_unknown_units(warnings);
  if (!axis_ && !rate_ && options.allow_untimed && (cells_.size() > 1 || options.rate)) {
    rate_ = options.rate.value_or(1.0);
    untimed_ = true;
  }
  if (!axis_ && !rate_ && text_times_) throw_text_times();
  if (!axis_ && !rate_) throw_no_axis();
  if (axis_ && columns_.size() < 2) {
    throw FormatError(cells_.front().place, "a column in addition to the axis",
                      fmt::format("{} alone", label(0)));
  }
}

void RecordingCsvHeader::resolve_axis(const AssumedUnits& assumed) {
  RecordingColumn& column = columns_[*axis_];
  if (column.dimension) {
    if (!assumed.names(column.name)) return;
    const std::optional<Unit> unit = assumed.find(column.name);
    if (unit_mark_ == UnitMark::kUnderscore && unit->dimension == column.dimension) {
      column.unit = *unit;
      return;
    }
    throw InputError(fmt::format("{}: {}", file_, label(*axis_)), dimension_name(*column.dimension),
                     "must have no unit if one is assumed", "The unit in the file is used.");
  }
  const Dimension dimension = axis_dimension(column.name).value_or(kTime);
  if (!column.unknown_unit.empty() && !assumed.names(column.name)) {
    throw FormatError(cells_[*axis_].place,
                      fmt::format("a unit for column {} {}", *axis_ + 1, in_quotes(column.name)),
                      fmt::format("the unknown unit {}", in_quotes(column.unknown_unit)),
                      fmt::format("Usual units: {}.", usual_units(dimension)));
  }
  const std::optional<Unit> unit = assumed.find(column.name);
  if (!unit) {
    throw FormatError(
        cells_[*axis_].place,
        fmt::format("a unit of {} for column {}", dimension_name(dimension), *axis_ + 1),
        fmt::format("{} without one", in_quotes(column.name)),
        fmt::format("Write '{} [{}]', or give `assume_units {}={}`.", column.name,
                    si_unit(dimension), column.name, si_unit(dimension)));
  }
  if (unit->dimension != dimension) {
    throw InputError(fmt::format("{}: unit assumed for {}", file_, label(*axis_)),
                     dimension_name(unit->dimension),
                     fmt::format("must be one of {}", dimension_name(dimension)));
  }
  column.unit = *unit;
  column.dimension = unit->dimension;
  column.unknown_unit.clear();
}

void RecordingCsvHeader::throw_no_axis() const {
  std::string names;
  for (const Cell& cell : cells_) names += (names.empty() ? "" : ", ") + cell.column.name;
  throw FormatError(cells_.front().place, "a column of time such as 'time [s]'",
                    fmt::format("the columns {}", in_quotes(names, 120)),
                    cells_.size() == 1
                        ? "Is this line the header? Lines above it begin with '#'. Columns are "
                          "separated by commas, semicolons or tabs. Or give the rate by `rate`."
                        : "Name it with its unit, or give the rate by `rate` or in a comment line "
                          "such as '# sampling_rate: 8192 Hz'.");
}

void RecordingCsvHeader::throw_text_times() const {
  throw FormatError(cells_[*text_times_].place,
                    fmt::format("times as numbers in {}", label(*text_times_)),
                    fmt::format("text, {}", in_quotes(text_time_)),
                    "Write seconds from the start, with the unit [s], or give the rate by `rate`.");
}

std::string RecordingCsvHeader::label(std::size_t i) const {
  const auto& [name, unit] = cells_[i].column;
  return fmt::format("column {} {}", i + 1,
                     in_quotes(unit ? fmt::format("{} [{}]", name, *unit) : name));
}

}  // namespace microslip
