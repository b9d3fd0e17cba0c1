// SPDX-License-Identifier: MIT
#include "microslip/io/loggers/lvm_contents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/cells/csv_cells.hpp"

namespace microslip {
namespace {

constexpr std::string_view kEndOfHeader = "***End_of_Header***";
constexpr std::string_view kStartOfSpecial = "***Start_Special***";
constexpr std::string_view kEndOfSpecial = "***End_Special***";
constexpr std::string_view kNameOfX = "X_Value";

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

using LvmCells = std::vector<std::string_view>;

/// The lines of a text, each as cells.
class LvmLines {
 public:
  explicit LvmLines(std::string_view text) : rest_(text) {}

  char separator = '\t';

  /// False at the end.
  bool next() {
    if (std::exchange(again_, false)) return true;
    if (rest_.empty()) return false;
    std::string_view line = take_dos_line(rest_);
    ++number_;
    cells_.clear();
    for (;;) {
      const std::size_t cut = line.find(separator);
      cells_.push_back(trimmed(line.substr(0, cut)));
      if (cut == std::string_view::npos) return true;
      line.remove_prefix(cut + 1);
    }
  }

  /// The next line is this one again.
  void put_back() { again_ = true; }

  [[nodiscard]] const LvmCells& cells() const { return cells_; }
  [[nodiscard]] std::string_view tag() const { return cells_.front(); }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool is_blank() const {
    return std::ranges::all_of(cells_, &std::string_view::empty);
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  bool again_ = false;
  LvmCells cells_;
};

bool is_no_number(std::string_view cell) {
  const std::string text = in_capitals(cell);
  return text == "NAN" || text == "INF" || text == "-INF";
}

/// Header and columns of a section as they stand.
struct RawSection {
  LvmHeader header = {};
  std::vector<std::string> names = {};
  bool has_comment = false;
  std::size_t line = 0;
  std::vector<LvmColumn> columns = {};
};

enum class LvmX { kNone, kOne, kEach };

/// Which of the columns of a section are x and where the header has the entries of the others.
class LvmLayout {
 public:
  LvmLayout(const RawSection& raw, LvmX stated) : raw_(raw), x_(stated) {
    const bool has_first = !raw.columns.empty() && !raw.columns.front().values.empty();
    skips_first_ = x_ != LvmX::kNone || first_is_x(has_first);
    if (x_ == LvmX::kNone && skips_first_ && has_first) x_ = LvmX::kOne;
    has_wide_header_ = x_ == LvmX::kEach && is_wide();
  }

  /// @param columns  those of the section.
  [[nodiscard]] LvmSection section(std::vector<LvmColumn> columns) const {
    LvmSection section{.header = raw_.header, .line = raw_.line};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool is_x = x_ == LvmX::kEach ? i % 2 == 0 : i == 0 && x_ == LvmX::kOne;
      if (is_x) section.x.push_back(std::move(columns[i]));
      if (is_x || (i == 0 && skips_first_)) continue;
      const std::size_t index = section.channels.size();
      section.channels.push_back({.column = std::move(columns[i]),
                                  .number = i + 1,
                                  .cell = has_wide_header_ ? i - 1 : index,
                                  .x = section.x.empty() ? 0 : section.x.size() - 1});
    }
    return section;
  }

 private:
  /// Without columns of x LabVIEW leaves their place blank; other programs leave it out.
  [[nodiscard]] bool first_is_x(bool has_values) const {
    const std::string_view name = raw_.names.front();
    if (name == kNameOfX || (name.empty() && !has_values)) return true;
    const auto found = raw_.header.find("Channels");
    if (found == raw_.header.end() || found->second.empty()) return true;
    const auto channels = parse_number(found->second.front());
    return !channels || *channels != static_cast<double>(raw_.columns.size());
  }

  /// Whether the entries of channels stand above their columns, so that every second cell is blank.
  [[nodiscard]] bool is_wide() const {
    constexpr std::array<std::string_view, 9> kOfChannels{
        "Samples",     "Date",        "Time", "Y_Unit_Label", "X_Unit_Label",
        "X_Dimension", "Y_Dimension", "X0",   "Delta_X"};
    for (const std::string_view tag : kOfChannels) {
      const auto found = raw_.header.find(tag);
      if (found == raw_.header.end()) continue;
      for (std::size_t i = 1; i < found->second.size(); i += 2) {
        if (!found->second[i].empty()) return false;
      }
    }
    return true;
  }

  const RawSection& raw_;
  LvmX x_;
  bool skips_first_ = false;
  bool has_wide_header_ = false;
};

class LvmParser {
 public:
  LvmParser(std::string_view text, const std::string& path) : path_(path), lines_(text) {}

  LvmContents parse() {
    read_file_header();
    RawSection section;
    while (read_section_header(section)) {
      read_rows(section);
      const LvmLayout layout(section, x_);
      contents_.sections.push_back(layout.section(std::move(section.columns)));
    }
    return std::move(contents_);
  }

 private:
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    throw FormatError({path_, lines_.number(), 0}, expected, found,
                      "If LabVIEW did not write it so, save it as CSV.");
  }

  void read_file_header() {
    while (lines_.next()) {
      const LvmCells& cells = lines_.cells();
      const std::string_view value = cells.size() > 1 ? cells[1] : std::string_view{};
      if (cells.front() == kEndOfHeader) return;
      if (cells.front().starts_with("Separator")) take_separator(cells.front(), value);
      if (cells.front() == "Decimal_Separator") contents_.comma = value == ",";
      if (cells.front() == "Time_Pref") contents_.has_absolute_times = value == "Absolute";
      if (cells.front() == "X_Columns") {
        x_ = value == "One" ? LvmX::kOne : value == "Multi" ? LvmX::kEach : LvmX::kNone;
      }
    }
    fail(kEndOfHeader, "the end of the file");
  }

  /// The line is in the separator that it names.
  void take_separator(std::string_view cell, std::string_view value) {
    if (value == "Comma" || cell.ends_with(",Comma")) lines_.separator = ',';
  }

  /// False where there is no further section. One without header has that of the last.
  bool read_section_header(RawSection& section) {
    RawSection next;
    for (;;) {
      if (!lines_.next()) return false;
      const LvmCells& cells = lines_.cells();
      if (lines_.is_blank()) continue;
      if (cells.front() == kStartOfSpecial) {
        skip_special();
      } else if (cells.front() == kEndOfHeader) {
        break;
      } else if (next.header.empty() && !section.names.empty() && is_row(cells)) {
        lines_.put_back();
        next.header = section.header;
        return start_rows(section, std::move(next), section.names);
      } else {
        next.header[std::string(cells.front())].assign(cells.begin() + 1, cells.end());
      }
    }
    if (!lines_.next()) fail("the line of the names", "the end of the file");
    const LvmCells& names = lines_.cells();
    return start_rows(section, std::move(next), {names.begin(), names.end()});
  }

  bool start_rows(RawSection& section, RawSection next, std::vector<std::string> names) const {
    next.line = lines_.number();
    next.names = std::move(names);
    auto end = std::ranges::find(next.names, "Comment");
    next.has_comment = end != next.names.end();
    for (auto name = next.names.begin(); name != end; ++name) next.columns.push_back({*name});
    section = std::move(next);
    return true;
  }

  void skip_special() {
    while (lines_.next()) {
      if (lines_.tag() == kEndOfSpecial) return;
    }
    fail(kEndOfSpecial, "the end of the file");
  }

  /// Whether these are values and not a line of a header: its tag is no number.
  [[nodiscard]] bool is_row(const LvmCells& cells) const {
    return cells.front().empty() || is_no_number(cells.front()) ||
           lvm_number(cells.front(), contents_.comma).has_value();
  }

  /// To the blank line behind them.
  void read_rows(RawSection& section) {
    std::size_t row = 0;
    for (; lines_.next() && !lines_.is_blank(); ++row) {
      const LvmCells& cells = lines_.cells();
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i >= section.columns.size() && section.has_comment) break;
        if (!cells[i].empty()) add_cell(section, i, row, cells[i]);
      }
    }
  }

  /// A column may be without name.
  void add_cell(RawSection& section, std::size_t column, std::size_t row, std::string_view cell) {
    const auto value = lvm_number(cell, contents_.comma);
    if (!value && !is_no_number(cell)) fail("a number", in_quotes(cell));
    while (section.columns.size() <= column) section.columns.emplace_back();
    LvmColumn& to = section.columns[column];
    to.values.resize(row, kMissing);
    to.values.push_back(value.value_or(kMissing));
    if (value && (column == 0 || x_ == LvmX::kEach)) to.digits.add(cell);  // may be x
  }

  const std::string& path_;
  LvmLines lines_;
  LvmX x_ = LvmX::kNone;
  LvmContents contents_;
};

}  // namespace

std::string_view LvmSection::entry(std::string_view tag, const LvmChannel& channel) const {
  const auto found = header.find(tag);
  if (found == header.end() || channel.cell >= found->second.size()) return {};
  return found->second[channel.cell];
}

std::optional<double> lvm_number(std::string_view text, bool comma) {
  return comma ? parse_comma_number(text) : parse_number(text);
}

LvmContents parse_lvm(std::string_view text, const std::string& path) {
  return LvmParser(text, path).parse();
}

}  // namespace microslip
