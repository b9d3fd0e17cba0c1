// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/recording_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <functional>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/line_blocks.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/recordings/even_axis.hpp"
#include "microslip/io/recordings/recording_csv_header.hpp"
#include "microslip/io/recordings/sampling.hpp"
#include "microslip/io/recordings/table_start.hpp"

namespace microslip {
namespace {

/// How the numbers of a file are written; unknown until one has a point or a comma.
enum class Decimal { kUnknown, kPoint, kComma };

/// As Python, MATLAB and Excel write complex numbers: (1.5-2e3j), 1 + 2i.
bool is_complex_cell(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('(') && text.ends_with(')')) text = text.substr(1, text.size() - 2);
  const bool is_marked = text.size() > 1 && (text.ends_with('i') || text.ends_with('j'));
  return is_marked && text.find_first_of("0123456789") < text.size() &&
         text.substr(0, text.size() - 1).find_first_not_of("0123456789+-.,eE* ") ==
             std::string_view::npos;
}

/// A number as `1,004`, in groups of three digits that do not begin with 0.
bool may_be_thousands(std::string_view text) {
  constexpr std::size_t kGroup = 3;
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t first = text.find(',');
  if (first == 0 || first > kGroup || text[0] == '0') return false;
  for (text.remove_prefix(first); !text.empty(); text.remove_prefix(kGroup + 1)) {
    if (text[0] != ',' || text.size() <= kGroup) return false;
    if (text.substr(1, kGroup).find_first_not_of("0123456789") != std::string_view::npos) {
      return false;
    }
  }
  return true;
}

class CsvRecordingReader {
 public:
  CsvRecordingReader(InputStream& file, const RecordingReadOptions& options)
      : file_(file), options_(options), blocks_(file), header_(file.name()) {}

  Recordings read() {
    while (blocks_.next()) {
      if (blocks_.first_line() == 1) check_signature();
      read_block();
      report_progress();
      reserve();
    }
    if (!header_.has_names()) throw_no_header();
    if (rows_ < 2) {
      throw FormatError({file_.name(), 0, 0}, "two rows of values below the header",
                        fmt::format("{}", rows_));
    }
    return result();
  }

 private:
  // ---- Lines. ----

  void check_signature() const {
    const std::string_view other = signature(blocks_.text());
    if (other.empty()) return check_no_model();
    throw FormatError({file_.name(), 0, 0}, "a table of comma-separated values", other,
                      remedy_for_signature(other));
  }

  /// Matrices and meshes begin as no table does.
  void check_no_model() const {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kModels{
        {{"%%MatrixMarket", "a matrix of Matrix Market"},
         {"$MeshFormat", "a mesh of gmsh"},
         {"*NODE", "an input file of Abaqus or CalculiX"},
         {"*HEADING", "an input file of Abaqus or CalculiX"}}};
    for (const auto& [start, name] : kModels) {
      if (!blocks_.text().starts_with(start)) continue;
      throw FormatError({file_.name(), 0, 0}, "a table of comma-separated values", name,
                        "It is no recording. `modes` takes matrices and nodes that a structure "
                        "file, schema = \"microslip.structure/1\", names.");
    }
  }

  [[noreturn]] void throw_no_header() const {
    throw FormatError(
        {file_.name(), 0, 0}, "a header such as 'time [s],force [N],acc1 [m/s^2]'",
        blocks_.bytes_done() == 0 ? "an empty file" : "nothing but blanks and comments",
        "Was it written to its end?");
  }

  [[noreturn]] void throw_unnamed(const UnnamedRows& rows) const {
    throw FormatError({file_.name(), rows.line, 1},
                      fmt::format("a line of {} names above the rows of numbers", rows.cells),
                      "rows of numbers that begin here, without names",
                      fmt::format("Put one above line {}, such as 'time [s]', 'force [N]', "
                                  "separated as the rows are; a column of text needs a name, too.",
                                  rows.line));
  }

  void read_block() {
    const std::string_view text = blocks_.text();
    end_ = text.data() + text.size();
    scanner_ = CellScanner(text, file_.name(), header_.separator(), blocks_.first_line());
    const char* p = text.data();
    if (blocks_.first_line() == 1) {
      if (text.starts_with(kByteOrderMark)) p += kByteOrderMark.size();
      table_ = find_table_start(text);
      if (table_.unnamed) throw_unnamed(*table_.unnamed);
    }
    while (p != end_) p = read_line(p);
  }

  const char* read_line(const char* p) {
    if (const char* next = skip_blank_or_comment(p)) return next;
    if (header_resolved_) return read_row_to_the_end(p);
    return read_header_line(p);
  }

  /// Nothing where the line is neither.
  const char* skip_blank_or_comment(const char* p) {
    if (*p >= '0' && *p <= '9') return nullptr;  // the common case
    const char* first = p;
    while (first != end_ && (*first == ' ' || *first == '\t')) ++first;
    const std::string_view rest(first, static_cast<std::size_t>(end_ - first));
    const std::size_t mark = rest.starts_with("//")                                ? 2
                             : !rest.empty() && (rest[0] == '#' || rest[0] == '%') ? 1
                                                                                   : 0;
    if (mark == 0) return scanner_->at_line_end(first) ? scanner_->skip_line_end(first) : nullptr;
    const std::string_view line = rest.substr(0, rest.find('\n'));
    header_.add_comment(line.substr(mark, line.size() - mark - (line.ends_with('\r') ? 1 : 0)));
    return scanner_->skip_line_end(line.data() + line.size());
  }

  const char* read_header_line(const char* p) {
    const std::string_view rest(p, static_cast<std::size_t>(end_ - p));
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const std::size_t number = scanner_->place(p).line;
    const bool above = !table_.preamble.empty() && p < blocks_.text().data() + table_.header;
    const bool before_units =
        blocks_.first_line() == 1 && table_.units > 0 && p < blocks_.text().data() + table_.units;
    if (header_.has_names() && before_units) {
      header_.add_preamble(line);
    } else if (!header_.has_names() && above && blocks_.first_line() == 1) {
      header_.add_preamble(line);
    } else if (!header_.has_names() && !table_.commented.empty()) {
      header_.read_names(table_.commented, scanner_->place(table_.commented.data()).line, table_);
      start_rows();
      return p;
    } else if (!header_.has_names()) {
      header_.read_names(line, number, table_);
    } else {
      const bool units = header_.read_units(line, number);
      start_rows();
      if (!units) return p;
    }
    return scanner_->skip_line_end(line.data() + line.size());
  }

  /// The header is known as a whole.
  void start_rows() {
    header_.resolve(options_, table_, warnings_);
    if (table_.blanks && table_.counts) header_.check_counted_rows();
    header_resolved_ = true;
    values_.resize(header_.columns().size());
    left_out_.resize(header_.columns().size());
    if (header_.separator() == ',' || table_.blanks) decimal_ = Decimal::kPoint;
    scanner_ = CellScanner(blocks_.text(), file_.name(), header_.separator(), blocks_.first_line());
  }

  // ---- Rows. ----

  /// A row; where the file ends within it, that may be forgiven.
  const char* read_row_to_the_end(const char* p) {
    if (end_[-1] == '\n') return read_row(p);
    const std::string_view rest(p, static_cast<std::size_t>(end_ - p));
    if (rest.find('\n') != std::string_view::npos) return read_row(p);
    return read_last_row(p);
  }

  /// The last line has no line break. Whether its last number is complete is unknown.
  const char* read_last_row(const char* p) {
    const std::string line = std::to_string(scanner_->place(p).line);
    if (options_.allow_truncated && rows_ > 0) {
      warnings_.push_back(
          {"last_row_dropped", file_.name() + ":" + line +
                                   ": the last row has no line break and was left out; the file "
                                   "may have been truncated within it."});
      return end_;
    }
    row_is_cut_ = true;
    const char* next = read_row(p);
    warnings_.push_back(
        {"last_row_open", file_.name() + ":" + line +
                              ": the last row has no line break; if the file was truncated there, "
                              "its last number is wrong. `allow_truncated` leaves the row out."});
    return next;
  }

  const char* read_row(const char* p) {
    row_ = p;
    const std::size_t columns = values_.size();
    for (std::size_t column = 0;; ++column) {
      const char* next = read_cell(p, column);
      if (scanner_->at_line_end(next)) {
        if (column + 1 != columns) throw_ragged();
        ++rows_;
        return scanner_->skip_line_end(next);
      }
      p = scanner_->behind(next);
      if (column + 1 == columns) {
        const char* end = scanner_->skip_blanks(p);  // one separator too many may end a line
        if (!scanner_->at_line_end(end)) throw_ragged();
        ++rows_;
        return scanner_->skip_line_end(end);
      }
      if (scanner_->at_line_end(scanner_->skip_blanks(p)) && column + 2 != columns) {
        throw_ragged();
      }
    }
  }

  /// Appends a number to its column; returns where the cell ends.
  const char* read_cell(const char* p, std::size_t column) {
    const char* begin = scanner_->skip_blanks(p);
    if (left_out_[column]) return scanner_->scan(begin).next;
    double printed = 0.0;
    const char* next = decimal_ == Decimal::kUnknown ? nullptr : read_common_cell(begin, printed);
    if (next == nullptr) {
      next = read_other_cell(begin, column, printed);
      if (left_out_[column]) return next;
    }
    const double value = header_.columns()[column].unit.to_si(printed);
    if (!std::isfinite(value)) throw_no_number(begin, column);
    if (column == header_.axis()) add_to_axis(begin, next, value);
    values_[column].push_back(value);
    return next;
  }

  /// Without a look for the cell's end: where the number stops, the cell must stop.
  const char* read_common_cell(const char* p, double& value) {
    auto [stop, error] = std::from_chars(p, end_, value);
    if (decimal_ == Decimal::kComma) {
      if (stop != end_ && *stop == ',') {
        std::tie(stop, error) = read_comma_number(p, stop, value);
      } else if (std::find(p, stop, '.') != stop) {
        return nullptr;
      }
    }
    if (error != std::errc{} || !std::isfinite(value)) return nullptr;
    stop = scanner_->skip_blanks_behind(stop);
    return scanner_->at_cell_end(stop) ? stop : nullptr;
  }

  /// from_chars knows the point alone: the comma becomes one for a moment.
  std::pair<const char*, std::errc> read_comma_number(const char* p, const char* comma,
                                                      double& value) {
    char& mark = blocks_.writable_text()[static_cast<std::size_t>(comma - blocks_.text().data())];
    mark = '.';
    const auto [stop, error] = std::from_chars(p, end_, value);
    mark = ',';
    return {stop, error};
  }

  const char* read_other_cell(const char* p, std::size_t column, double& value) {
    const RawCell cell = scanner_->scan(p);
    const std::string_view text = cell.view();
    std::optional<double> number;
    if (decimal_ != Decimal::kComma) number = parse_number(text);
    if (!number && decimal_ != Decimal::kPoint) number = parse_comma_number(text);
    if (!number && decimal_ != Decimal::kComma) number = parse_fortran_number(text);
    for (const auto& [decimal, mark] : {std::pair{Decimal::kComma, ','}, {Decimal::kPoint, '.'}}) {
      if (number || (decimal_ != decimal && decimal_ != Decimal::kUnknown)) continue;
      number = parse_grouped_number(text, mark);
      if (number) decimal_ = decimal;
    }
    if (!number) {
      // A column of text or with a cell without a value is no channel, and none of the others'.
      if (row_is_cut_ || column == header_.axis()) throw_no_number(p, column);
      left_out_[column] = no_number(p, column);
      std::vector<double>().swap(values_[column]);
      return cell.next;
    }
    if (decimal_ == Decimal::kUnknown) {
      if (text.find('.') != std::string_view::npos) decimal_ = Decimal::kPoint;
      if (text.find(',') != std::string_view::npos) decimal_ = Decimal::kComma;
    }
    value = *number;
    return cell.next;
  }

  void add_to_axis(const char* begin, const char* end, double value) {
    std::vector<double>& axis = values_[*header_.axis()];
    const std::string_view text(begin, static_cast<std::size_t>(end - begin));
    if (!axis.empty() && !(value > axis.back()) && !forgives_fall(begin, text, value)) return;
    digits_.add(text);
  }

  /// Equal times may be those of a clock that rounds, which result() decides. False where the
  /// column is no longer the axis.
  /// @throws FormatError  where the axis falls.
  bool forgives_fall(const char* begin, std::string_view text, double value) {
    const std::size_t column = *header_.axis();
    const bool equal = value == values_[column].back();
    if (equal && equal_times_) return true;
    if (count_cells() < values_.size()) throw_ragged();  // then it is another column
    if (header_.columns()[column].dimension == kFrequency && header_.sampling_rate()) {
      header_.drop_axis();
      return false;
    }
    FormatError fault(
        scanner_->place(begin),
        fmt::format("a value above that of the row before in {}", header_.label(column)),
        in_quotes(trimmed(text)),
        equal ? "Write it with more digits, or remove the row."
              : "Sort the rows, or split the file there.");
    if (!equal) throw FormatError(fault);
    equal_times_ = std::move(fault);
    return true;
  }

  // ---- What is wrong with a row. ----

  [[nodiscard]] std::size_t count_cells() const {
    std::size_t cells = 1;
    RawCell cell = scanner_->scan(row_);
    while (!scanner_->at_line_end(scanner_->skip_blanks(cell.next))) {
      cell = scanner_->scan(scanner_->behind(cell.next));
      ++cells;
    }
    return cells;
  }

  [[noreturn]] void throw_ragged() const {
    const std::size_t cells = count_cells();
    if (row_is_cut_ && cells < values_.size()) {
      throw FormatError(scanner_->place(row_),
                        fmt::format("{} cells as in the header", values_.size()),
                        fmt::format("{} and the end of the file", cells),
                        "It was truncated; `allow_truncated` leaves out this row.");
    }
    throw ragged_row(scanner_->place(row_), values_.size(), cells, header_.separator());
  }

  [[noreturn]] void throw_no_number(const char* p, std::size_t column) const {
    throw no_number(p, column);
  }

  [[nodiscard]] FormatError no_number(const char* p, std::size_t column) const {
    const RawCell cell = scanner_->scan(p);
    const std::string_view text = cell.view();
    std::string remedy(remedy_for_cell(text));
    if (is_complex_cell(text)) {
      const std::string& name = header_.columns()[column].name;
      remedy = fmt::format("It is complex: write its parts as columns {} and {}.",
                           in_quotes(name + std::string(kRealMark)),
                           in_quotes(name + std::string(kImaginaryMark)));
    } else if (decimal_ == Decimal::kComma && text.find('.') != std::string_view::npos) {
      remedy = "This table has decimal commas elsewhere: write all numbers one way.";
    } else if (decimal_ == Decimal::kPoint && parse_comma_number(text)) {
      const bool by_points = header_.separator() == ',' || header_.separator() == ' ';
      remedy = by_points ? std::string(kRemedyForDecimalCommas)
                         : "This table has decimal points elsewhere: write all numbers one way.";
      if (by_points && may_be_thousands(text)) {
        remedy =
            "Where its comma separates thousands, write it without; where decimals, with a point.";
      }
    } else if (row_is_cut_) {
      remedy = "If the file was truncated there, `allow_truncated` leaves out this row.";
    }
    return {scanner_->place(cell.begin),
            fmt::format("a finite number in {}", header_.label(column)),
            text.empty() ? "an empty cell" : in_quotes(text), remedy};
  }

  // ---- The whole. ----

  void report_progress() const {
    if (!options_.progress || !file_.size()) return;
    const std::size_t total = std::max(*file_.size(), blocks_.bytes_done());  // it may grow
    if (!options_.progress(blocks_.bytes_done(), total)) throw Cancelled();
  }

  /// Room for all rows, guessed from those so far: growing step by step would copy them again and
  /// again, and need twice the memory meanwhile. Where there is not so much, the rest may be less
  /// than it seems, as zeros that a crash has left.
  void reserve() {
    if (rows_ == 0 || !file_.size() || blocks_.bytes_done() >= *file_.size()) return;
    const double share =
        static_cast<double>(*file_.size()) / static_cast<double>(blocks_.bytes_done());
    const double rows = 1.01 * share * static_cast<double>(rows_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (left_out_[i] || static_cast<double>(values_[i].capacity()) >= rows) continue;
      try {
        values_[i].reserve(static_cast<std::size_t>(1.05 * rows));
      } catch (const std::bad_alloc&) {
        return;
      }
    }
  }

  Recordings result() {
    Recording recording;
    const std::string& name = file_.name();
    recording.source = name.substr(name.rfind('/') + 1);
    if (header_.axis()) {
      recording.axis = axis_of_times(std::move(values_[*header_.axis()]));
      warn_of_other_rate(recording.axis);
      warn_of_unused_rate(recording.axis);
      warn_of_other_times(recording.axis);
    } else {
      recording.axis.step = 1.0 / *header_.sampling_rate();
      if (!header_.is_untimed()) warn_of_frequencies();
    }
    leave_out_halves();
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (i != header_.axis() && !left_out_[i]) add_channel(recording, i);
    }
    leave_out(recording);
    distribute_attributes(recording);
    check_recording(recording);
    Recordings recordings{
        .recordings = {}, .warnings = std::move(warnings_), .rate_used = rate_used_};
    recordings.recordings.push_back(std::move(recording));
    if (header_.is_untimed() && !options_.no_axis) note_untimed(options_, file_.name(), recordings);
    return recordings;
  }

  /// @throws FormatError  where times are equal and no clock explains it.
  /// @throws InputError  as axis_of_clock().
  Axis axis_of_times(std::vector<double> values) {
    const Unit& unit = header_.columns()[*header_.axis()].unit;
    Axis axis{.dimension = unit.dimension, .start = 0.0, .step = 0.0, .values = {}};
    if (equal_times_) {
      axis.values = std::move(values);
    } else {
      axis = axis_from_printed(std::move(values), unit, digits_);
    }
    if (axis.even()) return axis;
    const StatedRates rates{.asked = options_.rate, .in_file = header_.sampling_rate()};
    if (auto clock = axis_of_clock(axis.values, unit, digits_, rates, file_.name(), warnings_)) {
      rate_used_ = options_.rate.has_value();
      return *std::move(clock);
    }
    if (equal_times_) throw FormatError(*equal_times_);
    return axis;
  }

  void warn_of_unused_rate(const Axis& axis) {
    if (axis.dimension != kFrequency || !header_.sampling_rate()) return;
    const std::string name = in_quotes(header_.columns()[*header_.axis()].name);
    warnings_.push_back(
        {"axis_chosen",
         fmt::format("{}: {} is taken for the axis, though a comment gives {:.6g} Hz as the "
                     "sampling rate. Where the values are over time, give {} another name, such "
                     "as 'drive'",
                     file_.name(), name, *header_.sampling_rate(), name)});
  }

  /// Whether a column is a time over which others may be.
  [[nodiscard]] bool is_time(std::size_t i) const {
    const RecordingColumn& column = header_.columns()[i];
    return column.dimension == kTime &&
           rank_as_axis(column.name, column.unit) <= AxisRank::kLongTime;
  }

  /// Whether the column behind another is no time.
  [[nodiscard]] bool stands_before_channel(std::size_t i) const {
    return i + 1 < values_.size() && !is_time(i + 1);
  }

  /// Columns behind a second time may be over that: loggers write pairs of time and value.
  void warn_of_other_times(const Axis& axis) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (left_out_[i] || i == header_.axis() || !is_time(i) || axis.dimension != kTime) continue;
      const std::vector<double>& times = values_[i];
      if (times.size() < 2 || !std::ranges::is_sorted(times)) continue;
      const std::string how = difference_of(axis, times, i);
      if (how.empty()) continue;
      warnings_.push_back(
          {"other_times",
           fmt::format("{}: {} rises as well, {}: where columns are over it, put it and them into "
                       "a file of their own",
                       file_.name(), in_quotes(header_.columns()[i].name), how)});
    }
  }

  /// How times of column i are others than the axis; empty where they are not. Another start alone
  /// matters where a channel stands behind each of the two.
  [[nodiscard]] std::string difference_of(const Axis& axis, const std::vector<double>& times,
                                          std::size_t i) const {
    constexpr double kSameSpan = 0.01;   // of the span
    constexpr double kSameStart = 0.01;  // of the step
    const std::size_t last = times.size() - 1;
    const double span = axis.at(last) - axis.at(0);
    const double other = times[last] - times[0];
    if (!(other > 0.0)) return {};
    if (std::abs(other - span) > kSameSpan * span) {
      return fmt::format("by {:.6g} s in place of {:.6g} s", other, span);
    }
    const double offset = times[0] - axis.at(0);
    const double step = span / static_cast<double>(last);
    const bool are_pairs = stands_before_channel(*header_.axis()) && stands_before_channel(i);
    if (!are_pairs || std::abs(offset) <= kSameStart * step) return {};
    return fmt::format(
        "from {:.6g} s on in place of {:.6g} s; no column is shifted by the {:.6g} s", times[0],
        axis.at(0), offset);
  }

  /// Where the rate is taken for the axis and frequencies rise, which may be it as well.
  void warn_of_frequencies() {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const std::string& name = header_.columns()[i].name;
      if (left_out_[i] || axis_dimension(name) != kFrequency) continue;
      const auto fall = std::ranges::adjacent_find(values_[i], std::greater_equal<>());
      if (fall != values_[i].end()) continue;
      warnings_.push_back(
          {"axis_chosen",
           fmt::format(
               "{}: the sampling rate that a comment gives is taken for the axis, though {} "
               "rises. Take the rate out where the values are over the latter",
               file_.name(), in_quotes(name))});
    }
  }

  void warn_of_other_rate(const Axis& axis) {
    constexpr double kSame = 1e-3;  // a rate is often rounded in a comment
    if (axis.dimension != kTime || !axis.even() || !header_.sampling_rate()) return;
    const double rate = *header_.sampling_rate();
    if (std::abs(rate * axis.step - 1.0) <= kSame) return;
    warnings_.push_back(
        {"sampling_rates_differ", fmt::format("{}: a comment gives the sampling rate as {:.6g} Hz, "
                                              "the times as {:.6g} Hz; the times are used.",
                                              file_.name(), rate, 1.0 / axis.step)});
  }

  /// Whether a column is the imaginary part of the one before it.
  [[nodiscard]] bool is_imaginary(std::size_t i) const {
    if (i == 0) return false;
    const RecordingColumn& real = header_.columns()[i - 1];
    const RecordingColumn& column = header_.columns()[i];
    return real.name.ends_with(kRealMark) && column.name.ends_with(kImaginaryMark) &&
           without(real.name, kRealMark) == without(column.name, kImaginaryMark) &&
           real.dimension == column.dimension;
  }

  /// A part of a complex channel is none without the other.
  void leave_out_halves() {
    for (std::size_t i = 1; i < left_out_.size(); ++i) {
      if (!is_imaginary(i)) continue;
      if (!left_out_[i]) left_out_[i] = left_out_[i - 1];
      if (!left_out_[i - 1]) left_out_[i - 1] = left_out_[i];
    }
  }

  /// A channel of its own, or the imaginary part of the one before it.
  void add_channel(Recording& recording, std::size_t i) {
    const RecordingColumn& column = header_.columns()[i];
    if (is_imaginary(i)) {
      Channel& last = recording.channels.back();
      last.name = without(column.name, kImaginaryMark);
      last.imaginary = std::move(values_[i]);
      return;
    }
    Channel& channel = recording.channels.emplace_back();
    channel.name = column.name;
    channel.dimension = column.dimension;
    channel.values = std::move(values_[i]);
    if (!column.unknown_unit.empty()) channel.attributes.emplace_back("unit", column.unknown_unit);
  }

  /// Says which columns are no channels. @throws FormatError  where none is one.
  void leave_out(Recording& recording) {
    for (std::size_t i = 0; i < left_out_.size(); ++i) {
      if (!left_out_[i]) continue;
      if (recording.channels.empty()) throw FormatError(*left_out_[i]);
      const std::string& name = header_.columns()[i].name;
      const std::string reason = left_out_[i]->what();
      recording.left_out.push_back({name, reason});
      warnings_.push_back({"channel_left_out", fmt::format("{}: channel {} is left out: {}",
                                                           file_.name(), in_quotes(name), reason)});
    }
  }

  static std::string_view without(std::string_view name, std::string_view mark) {
    return name.substr(0, name.size() - mark.size());
  }

  /// The channel of an attribute, and how much of its name tells that. Of names with marks in them
  /// the longest that fits is taken.
  static std::pair<Channel*, std::size_t> channel_of(Recording& recording, std::string_view name) {
    std::size_t mark = name.rfind(kChannelMark);
    while (mark != std::string_view::npos) {
      const auto channel =
          std::ranges::find(recording.channels, name.substr(0, mark), &Channel::name);
      if (channel != recording.channels.end()) return {&*channel, mark + kChannelMark.size()};
      mark = mark == 0 ? std::string_view::npos : name.rfind(kChannelMark, mark - 1);
    }
    return {nullptr, 0};
  }

  void distribute_attributes(Recording& recording) const {
    for (const auto& [name, value] : header_.attributes()) {
      const auto [channel, prefix] = channel_of(recording, name);
      Attributes& target = channel != nullptr ? channel->attributes : recording.attributes;
      target.emplace_back(name.substr(prefix), value);
    }
  }

  InputStream& file_;
  const RecordingReadOptions& options_;
  LineBlocks blocks_;
  RecordingCsvHeader header_;
  bool header_resolved_ = false;
  const char* row_ = nullptr;  ///< where the row begins that is read
  bool row_is_cut_ = false;
  bool rate_used_ = false;                  ///< that of the options
  std::optional<FormatError> equal_times_;  ///< the first time that is not above the one before
  Decimal decimal_ = Decimal::kUnknown;
  std::optional<CellScanner> scanner_;  ///< of the block
  const char* end_ = nullptr;           ///< of the block
  std::size_t rows_ = 0;
  std::vector<std::vector<double>> values_;           ///< by column, in SI
  std::vector<std::optional<FormatError>> left_out_;  ///< by column, why it is no channel
  TableStart table_;                                  ///< of the first block
  PrintedDigits digits_;                              ///< of the axis
  std::vector<Warning> warnings_;
};

}  // namespace

std::vector<CsvColumn> recording_columns(std::string_view head) {
  if (!signature(head).empty()) return {};
  const TableStart start = find_table_start(head);
  const bool commented = !start.commented.empty();
  RecordingCsvHeader header("");
  try {
    header.read_names(commented ? start.commented : start.names, 1, start);
    if (!commented) (void)header.read_units(start.below, 2);
    header.take_units_of_names({});
  } catch (const FormatError&) {
    return {};
  }
  return header.columns_as_written();
}

Recordings read_recordings_csv(const std::string& path, const RecordingReadOptions& options) {
  InputStream file(path);
  return read_recordings_csv(file, options);
}

Recordings read_recordings_csv(InputStream& file, const RecordingReadOptions& options) {
  return CsvRecordingReader(file, options).read();
}

}  // namespace microslip
