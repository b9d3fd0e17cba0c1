// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/io/recordings/axis_rank.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/io/recordings/table_start.hpp"
#include "microslip/io/recordings/unit_in_name.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// Between channel and name of an attribute, and behind the name of a complex channel.
inline constexpr std::string_view kChannelMark = " / ";
inline constexpr std::string_view kRealMark = ".real";
inline constexpr std::string_view kImaginaryMark = ".imag";

/// A column of a recording.
struct RecordingColumn {
  std::string name;
  Unit unit;                           ///< 1 where it has none
  std::optional<Dimension> dimension;  ///< nothing where it has none
  std::string unknown_unit = {};       ///< as in the file, where it is none that is known
};

/// Lines above the rows of a recording: comments, names, units.
class RecordingCsvHeader {
 public:
  explicit RecordingCsvHeader(std::string_view file) : file_(file) {}

  /// A comment line without its mark; an attribute in UTF-8.
  void add_comment(std::string_view text);

  /// A line above the table that is no comment; its cells are as one, empty ones at its end left
  /// out.
  void add_preamble(std::string_view line);

  /// The line of names; a column without one is called by its number.
  /// @param number  of the line. @param table  tells whether blanks alone separate columns of the
  ///                rows, where the names may have another separator, and how names stand.
  /// @throws FormatError  where all cells are numbers, or columns are separated by blanks and no
  ///                      rows are so.
  void read_names(std::string_view line, std::size_t number, const TableStart& table);

  /// The first line below it. False where that is no line of units: some names have units already,
  /// or a cell is a number other than 1, or none is a unit or in brackets.
  /// @throws FormatError  where it is one with more or fewer cells than the line of names.
  bool read_units(std::string_view line, std::size_t number);

  /// Takes units off names that have them without brackets, as `F/kN` does, where one is that of a
  /// time or frequency (unit_mark_of()). A unit that is assumed comes before one behind `_`.
  void take_units_of_names(const AssumedUnits& assumed);

  /// When both lines have been read, if the second is there. Columns of one name are distinguished
  /// by their units, else by their numbers.
  /// A frequency that rises is the axis before a column in a unit of time that is not called a
  /// time, with a warning; a column called time whose cells are text is no axis.
  /// @param warnings  on units that are not known, and on names that were changed.
  /// @throws FormatError  where the unit of the axis is unknown or missing, there is no axis or
  ///                      nothing beside it, or a word between blanks may be a name or the
  ///                      beginning of the next one.
  /// @param options  where a rate is stated a single column may be a channel, too.
  /// @param table    the first rows.
  void resolve(const RecordingReadOptions& options, const TableStart& table,
               std::vector<Warning>& warnings);

  /// Where the first cells of rows count these: such a number may have no name, so that words are
  /// the names of the columns behind.
  /// @throws FormatError  where the axis is there, words are names, and not all have units.
  void check_counted_rows() const;

  /// Names and units of the columns, as far as they have been read.
  [[nodiscard]] std::vector<CsvColumn> columns_as_written() const;
  [[nodiscard]] bool has_names() const { return !cells_.empty(); }
  [[nodiscard]] char separator() const { return separator_; }
  [[nodiscard]] const std::vector<RecordingColumn>& columns() const { return columns_; }
  /// The column of the axis; nothing where a comment gives the rate.
  [[nodiscard]] std::optional<std::size_t> axis() const { return axis_; }
  /// Makes a channel of the column of the axis: beside a rate a frequency is the axis only where it
  /// rises.
  void drop_axis() { axis_.reset(); }
  /// The rate that a comment gives, in Hz; that of untimed_step() where is_untimed().
  [[nodiscard]] std::optional<double> sampling_rate() const { return rate_; }
  /// Whether neither a column nor a comment says when rows were taken.
  [[nodiscard]] bool is_untimed() const { return untimed_; }
  [[nodiscard]] const Attributes& attributes() const { return attributes_; }
  /// For messages: "column 2 'force [N]'".
  [[nodiscard]] std::string label(std::size_t column) const;

 private:
  struct Cell {
    CsvColumn column;
    TextPlace place;
  };

  [[nodiscard]] std::vector<Cell> read_cells(std::string_view line, std::size_t number) const;
  void keep_indices();
  void check_words(const TableStart& table) const;
  void tell_names_apart(std::vector<Warning>& warnings);
  [[nodiscard]] RecordingColumn resolve_column(std::size_t column) const;
  void warn_of_units_in_names(std::vector<Warning>& warnings) const;
  void warn_of_unknown_units(std::vector<Warning>& warnings) const;
  [[nodiscard]] std::optional<AxisRank> axis_rank(std::size_t column, const AssumedUnits& assumed,
                                                  const std::vector<bool>& rising) const;
  [[nodiscard]] std::optional<std::size_t> find_axis(const AssumedUnits& assumed,
                                                     const std::vector<bool>& rising) const;
  void prefer_frequency(const AssumedUnits& assumed, const std::vector<bool>& rising,
                        std::vector<Warning>& warnings);
  void resolve_axis(const AssumedUnits& assumed);
  [[noreturn]] void throw_no_axis() const;
  [[noreturn]] void throw_text_times() const;

  std::string file_;
  char separator_ = ',';
  std::optional<UnitMark> unit_mark_;  ///< where names had units
  bool words_ = false;                 ///< whether names are words between blanks, without quotes
  std::vector<Cell> cells_;
  std::vector<RecordingColumn> columns_;
  std::optional<std::size_t> axis_;
  std::optional<std::size_t> text_times_;  ///< a column called time whose cells are text
  std::string text_time_;                  ///< the first of them
  std::optional<double> rate_;
  bool untimed_ = false;
  Attributes attributes_;
};

}  // namespace microslip
