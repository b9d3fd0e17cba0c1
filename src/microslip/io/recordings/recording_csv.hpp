// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/cells/csv_column.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// A recording as comma-separated text: a column of times and one per channel.
///
/// Form: UTF-8 with or without byte order mark, or CP1252; lines end in LF or CRLF. Lines that
/// begin with `#`, `%` or `//` are comments and may stand anywhere, blank lines too. The first
/// other line is the header: a cell a column, `name [unit]` or `name (unit)`. Lines above it that
/// are no comments are taken for such where two rows of numbers of as many cells as the header
/// follow it (table_start.hpp). Units may stand on a line of their own below it instead, with or
/// without brackets. A column without unit, with empty brackets or an unknown unit is a channel
/// without dimension; the unknown unit is its attribute `unit`. Columns of one name are called by
/// their units, `name (unit)`, else by their numbers. The separator is `;`, else a tab, else `,`,
/// the first of these that the header has, else blanks where they alone separate the numbers of the
/// rows; names of several words then have two blanks or more between them. Where rows of numbers
/// have no header, the comment above them gives the names where it has as many. Below, each row has
/// a finite number a column, with a decimal point, or, between `;` or tabs, a decimal comma
/// throughout, or an exponent of Fortran; cells may be quoted and one separator may end a line. A
/// column of which a cell is no finite number is left out with a warning.
///
/// The axis is a column with a unit of time or frequency, or called time, t, frequency or freq (in
/// capitals or not), the first of those that fit best (axis_rank.hpp); one without unit is refused
/// unless its unit is assumed. Its values rise. It is even where equal steps explain them to the
/// digits printed (even_axis.hpp). A frequency that rises in the first rows, the only one in Hz, is
/// the axis before a column in a unit of time that is not called a time, with a warning. A column
/// called time without a known unit whose cells are text is no axis. Where there is no such column,
/// a comment may give the rate: `# sampling_rate: 8192 Hz`, or = for the colon, or `fs`, `sampling
/// rate`, `sample rate`, `sampling frequency` for the name, in capitals or not; without unit it is
/// in Hz. The first point then lies at 0.
///
/// A comment `name: value` or `name = value` is an attribute, of a channel where it reads
/// `channel / name: value`; others are attributes of the name "comment". Two neighbouring columns
/// `name.real` and `name.imag` of one unit are one complex channel.

namespace microslip {

class InputStream;

/// The columns of a recording of which only the beginning is given, whole lines; their units may
/// stand on a line of their own, and other lines above. Empty where it is none.
[[nodiscard]] std::vector<CsvColumn> recording_columns(std::string_view head);

/// Reads the file from front to end, in pieces: beside the values there is no more than a few MiB
/// in memory.
/// @param path     "-" is standard input.
/// @param options  see RecordingReadOptions.
/// @throws FileError    where the file cannot be read.
/// @throws FormatError  naming the place, where it is not of the form above: empty, binary, without
///                      header, rows, a channel or an axis; a row with more or fewer cells than
///                      the header, a cell that is no finite number, columns without any, a time
///                      of unknown unit, times that do not rise. A file that was cut within a row
///                      is read as far as it is whole where the options allow that.
/// @throws InputError   where a unit is assumed for an axis that has one.
/// @throws Cancelled    where the progress callback says so.
[[nodiscard]] Recordings read_recordings_csv(const std::string& path,
                                             const RecordingReadOptions& options);

/// Reads a file that is already open, as above.
[[nodiscard]] Recordings read_recordings_csv(InputStream& file,
                                             const RecordingReadOptions& options);

/// Writes text that read_recordings_csv() reads back as the same recording, but for its source and
/// for characters that cannot be seen, such as U+200E, which names and attributes have as `\xNN`:
/// each number is the shortest that reads back as the same double. Times that are evenly spaced
/// read back as such, their start and step to rounding.
/// @param path       it is overwritten, if it is there; see OutputFiles::stage().
/// @param recording  over time or frequency.
/// @throws InputError  where check_recording() does, or the axis is neither time nor frequency.
/// @throws FileError   where the file cannot be written.
void write_recording_csv(const std::string& path, const Recording& recording);

/// The text that write_recording_csv() writes, for where it cannot be written in pieces.
/// @throws InputError  as there.
[[nodiscard]] std::string format_recording_csv(const Recording& recording);

}  // namespace microslip
