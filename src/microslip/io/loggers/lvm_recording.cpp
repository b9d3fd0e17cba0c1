// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/character_set.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/loggers/logger_recording.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

constexpr std::string_view kEndOfHeader = "***End_of_Header***";
constexpr std::string_view kStartOfSpecial = "***Start_Special***";
constexpr std::string_view kEndOfSpecial = "***End_Special***";

using Cells = std::vector<std::string_view>;

/// The lines of a text, each as cells.
class LvmLines {
 public:
  explicit LvmLines(std::string_view text) : rest_(text) {}

  char separator = '\t';

  /// False at the end.
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    cells_.clear();
    for (;;) {
      const std::size_t cut = line.find(separator);
      cells_.push_back(trimmed(line.substr(0, cut)));
      if (cut == std::string_view::npos) return true;
      line.remove_prefix(cut + 1);
    }
  }

  [[nodiscard]] const Cells& cells() const { return cells_; }
  [[nodiscard]] std::string_view tag() const { return cells_.front(); }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool is_blank() const {
    return std::ranges::all_of(cells_, &std::string_view::empty);
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  Cells cells_;
};

enum class LvmX { kNone, kOne, kEach };

/// What the header of the file states.
struct LvmForm {
  LvmX x = LvmX::kNone;
  bool comma = false;
};

/// A section: its header, and its columns of values.
struct LvmSection {
  std::map<std::string, std::vector<std::string>, std::less<>> header = {};
  std::vector<std::string> names = {};
  std::vector<std::vector<double>> columns = {};  ///< as they stand, those of x among them

  [[nodiscard]] std::string entry(std::string_view tag, std::size_t channel) const {
    const auto found = header.find(tag);
    if (found == header.end() || found->second.empty()) return {};
    return found->second[std::min(channel, found->second.size() - 1)];
  }
};

class LvmReader {
 public:
  LvmReader(const std::string& path, std::string text, bool allow_untimed)
      : path_(path), text_(to_utf8(text)), lines_(text_), allow_untimed_(allow_untimed) {}

  Recordings read() {
    read_file_header();
    while (read_section()) {
    }
    for (Recording& recording : recordings_) {
      check_foreign(recording, path_, result_.warnings);
      result_.recordings.push_back(std::move(recording));
    }
    if (result_.recordings.empty() && !without_axis_.empty()) {
      throw no_sampling_rate(without_axis_.front(), "Save it with a column of time, or Delta_X.");
    }
    if (result_.recordings.empty()) {
      throw FormatError({path_, lines_.number(), 0}, "a section of values", "none");
    }
    warn_without_rate(without_axis_, result_.warnings);
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    throw FormatError({path_, lines_.number(), 0}, expected, found,
                      "If LabVIEW did not write it so, save it as CSV.");
  }

  void read_file_header() {
    while (lines_.next()) {
      const Cells& cells = lines_.cells();
      const std::string_view value = cells.size() > 1 ? cells[1] : std::string_view{};
      if (cells.front() == kEndOfHeader) return;
      if (cells.front().starts_with("Separator")) take_separator(cells.front(), value);
      if (cells.front() == "Decimal_Separator") form_.comma = value == ",";
      if (cells.front() == "X_Columns") {
        form_.x = value == "One" ? LvmX::kOne : value == "Multi" ? LvmX::kEach : LvmX::kNone;
      }
    }
    fail(kEndOfHeader, "the end of the file");
  }

  /// The line is in the separator that it names.
  void take_separator(std::string_view cell, std::string_view value) {
    if (value == "Comma" || cell.ends_with(",Comma")) lines_.separator = ',';
  }

  /// False where there is no further section.
  bool read_section() {
    LvmSection section;
    for (;;) {
      if (!lines_.next()) return false;
      const Cells& cells = lines_.cells();
      if (lines_.is_blank()) continue;
      if (cells.front() == kStartOfSpecial) {
        skip_special();
      } else if (cells.front() == kEndOfHeader) {
        break;
      } else {
        section.header[std::string(cells.front())].assign(cells.begin() + 1, cells.end());
      }
    }
    if (!lines_.next()) fail("the line of the names", "the end of the file");
    for (const std::string_view name : lines_.cells()) section.names.emplace_back(name);
    read_rows(section);
    add(section);
    return true;
  }

  void skip_special() {
    while (lines_.next()) {
      if (lines_.tag() == kEndOfSpecial) return;
    }
    fail(kEndOfSpecial, "the end of the file");
  }

  /// To the blank line behind them.
  void read_rows(LvmSection& section) {
    const bool has_comment = !section.names.empty() && section.names.back() == "Comment";
    section.columns.resize(section.names.size() - (has_comment ? 1 : 0));
    while (lines_.next() && !lines_.is_blank()) {
      const Cells& cells = lines_.cells();
      for (std::size_t i = 0; i < std::min(cells.size(), section.columns.size()); ++i) {
        if (cells[i].empty()) continue;
        const auto value = form_.comma ? parse_comma_number(cells[i]) : parse_number(cells[i]);
        if (!value && !is_no_value(cells[i])) fail("a number", in_quotes(cells[i]));
        section.columns[i].push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
      }
    }
  }

  static bool is_no_value(std::string_view cell) {
    const std::string text = in_capitals(cell);
    return text == "NAN" || text == "INF" || text == "-INF";
  }

  void add(LvmSection& section) {
    std::vector<Recording> added;
    for (std::size_t i = 1, channel = 0; i < section.columns.size(); ++i) {
      if (form_.x == LvmX::kEach && i % 2 == 0) continue;
      std::vector<double>& values = section.columns[i];
      if (values.size() > 1) add_column(section, i, channel, std::move(values), added);
      ++channel;
    }
    for (Recording& recording : added) {
      if (!continues(recording)) recordings_.push_back(std::move(recording));
    }
  }

  void add_column(const LvmSection& section, std::size_t column, std::size_t index,
                  std::vector<double> values, std::vector<Recording>& added) {
    Channel channel;
    channel.name = section.names[column];
    if (channel.name.empty()) channel.name = fmt::format("channel_{}", index + 1);
    channel.values = std::move(values);
    const std::optional<Axis> axis = axis_of(section, column, index, channel.values.size());
    if (!axis) {
      without_axis_.push_back({fmt::format("{}: {}", path_, in_quotes(channel.name, 80))});
      return;
    }
    apply_unit(channel, section.entry("Y_Unit_Label", index), path_, result_.warnings);
    const std::string source =
        fmt::format("{}{}", file_name(path_),
                    recordings_.empty() ? "" : fmt::format(" #{}", recordings_.size() + 1));
    add_channel(added, source, *axis, std::move(channel), fmt::format("column {}", column + 1));
  }

  std::optional<Axis> axis_of(const LvmSection& section, std::size_t column, std::size_t channel,
                              std::size_t size) {
    const std::size_t x = form_.x == LvmX::kEach ? column - 1 : 0;
    const bool spectrum = section.entry("X_Dimension", channel) == "Frequency";
    if (form_.x != LvmX::kNone && section.columns[x].size() >= size) {
      std::vector<double> points(section.columns[x].begin(),
                                 section.columns[x].begin() + static_cast<std::ptrdiff_t>(size));
      const std::string unit = section.entry("X_Unit_Label", channel);
      return axis_of_points({std::move(points), unit, spectrum ? kFrequency : kTime, path_}, {})
          .axis;
    }
    const auto step = number_of(section, "Delta_X", channel);
    if (step && *step > 0.0) {
      Axis axis =
          even_axis({.step = *step, .start = number_of(section, "X0", channel).value_or(0)});
      if (spectrum) axis.dimension = kFrequency;
      return axis;
    }
    if (!allow_untimed_) return std::nullopt;
    if (result_.warnings.empty()) result_.warnings.push_back(points_untimed(path_));
    return even_axis({.step = 1.0});
  }

  [[nodiscard]] std::optional<double> number_of(const LvmSection& section, std::string_view tag,
                                                std::size_t channel) const {
    const std::string text = section.entry(tag, channel);
    return form_.comma ? parse_comma_number(text) : parse_number(text);
  }

  /// LabVIEW writes a section for each piece of a measurement that goes on: appends those.
  bool continues(Recording& next) {
    if (recordings_.empty()) return false;
    Recording& last = recordings_.back();
    if (!last.axis.even() || !next.axis.even() || last.axis.step != next.axis.step ||
        last.axis.dimension != next.axis.dimension ||
        last.channels.size() != next.channels.size()) {
      return false;
    }
    constexpr double kTenth = 0.1;
    const double gap = next.axis.start - last.axis.at(last.size());
    if (!(std::abs(gap) < kTenth * last.axis.step)) return false;
    for (std::size_t i = 0; i < last.channels.size(); ++i) {
      const Channel& a = last.channels[i];
      const Channel& b = next.channels[i];
      if (a.name != b.name || a.dimension != b.dimension) return false;
    }
    for (std::size_t i = 0; i < last.channels.size(); ++i) {
      std::vector<double>& to = last.channels[i].values;
      to.insert(to.end(), next.channels[i].values.begin(), next.channels[i].values.end());
    }
    return true;
  }

  const std::string& path_;
  std::string text_;
  LvmLines lines_;
  bool allow_untimed_;
  LvmForm form_;
  std::vector<Recording> recordings_;
  std::vector<WithoutAxis> without_axis_;
  Recordings result_;
};

}  // namespace

Recordings read_recordings_lvm(const std::string& path, const RecordingReadOptions& options) {
  return LvmReader(path, read_text(path), options.allow_untimed).read();
}

}  // namespace microslip
