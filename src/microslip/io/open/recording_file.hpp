// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/recordings/recording_format.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings in whatever format a file has.

namespace microslip {

/// The format of a file by its content, not by its name: a signature, the first line of a universal
/// file, or else a text. Whether a text is a recording is found out by reading it.
/// @throws FileError    where it cannot be read, or is a pipe, which could be read only once.
/// @throws FormatError  where it has the signature of something else.
[[nodiscard]] RecordingFormat recording_format(const std::string& path);

/// The format of a file of these first bytes; nothing where they are those of something else.
[[nodiscard]] std::optional<RecordingFormat> find_recording_format_of(std::string_view head);

/// The format that a name calls for: .csv; .uff .unv .uf (binary); .mat; .h5 .hdf5, in capitals or
/// not. Nothing where it ends otherwise.
[[nodiscard]] std::optional<RecordingFormat> find_recording_format_of_name(std::string_view path);

/// The format of an output, as find_recording_format_of_name(). "-" is CSV.
/// @throws InputError  where it ends otherwise.
[[nodiscard]] RecordingFormat recording_format_of_name(std::string_view path);

/// By the names of the command line: csv, uff (binary), uff-ascii, mat, h5.
[[nodiscard]] std::optional<RecordingFormat> find_recording_format(std::string_view name);

/// The kind (file_kind.hpp) that files of a format have; empty for CSV, where the columns tell it.
[[nodiscard]] std::string_view recording_kind(RecordingFormat format);

/// Reads a file of any format and gives channels without unit those that the options assume.
/// @param path     a file; or `FILE:VARIABLE` for a part of a MATLAB file, where there is no file
///                 of the whole name; or "-" for standard input: CSV, and a universal file where
///                 it is not a pipe.
/// @param options  see RecordingReadOptions.
/// @throws FileError, FormatError, Cancelled  as the readers of the formats.
/// @throws InputError  where an assumed unit does not fit, see assumed_units.hpp, or a variable is
///                     named for another format; as check_rate() and require_rate_used().
[[nodiscard]] Recordings read_recordings(const std::string& path,
                                         const RecordingReadOptions& options);

/// As above, of a file, not standard input, that was found to have a format by
/// find_recording_format_of(): it is opened once.
/// @param file     with a variable of kMat or kMat73 alone.
/// @param format   that was found.
/// @param options  see RecordingReadOptions.
[[nodiscard]] Recordings read_recordings(const PartOfFile& file, RecordingFormat format,
                                         const RecordingReadOptions& options);

/// Gives channels without unit those that are assumed, and warns of what no structure survives
/// (base/plausibility.hpp): half the range of a displacement, velocity or acceleration.
/// @throws InputError  as assume_units().
void finish_units(const AssumedUnits& units, Recordings& recordings);

/// Adds a file of recordings to those to be written.
/// @param files       of the set to which it is added.
/// @param path        "-", standard output, takes CSV alone.
/// @param recordings  one for CSV, any number for the others.
/// @param format      whatever the name of the file is.
/// @throws InputError  where CSV is to hold another number of recordings than one, or a recording
///                     cannot be written in the format.
/// @param replacing   which file of this name may be replaced.
/// @throws FileError   as OutputFiles::add().
void write_recordings(OutputFiles& files, const std::string& path,
                      std::span<const Recording> recordings, RecordingFormat format,
                      Replacing replacing = Replacing::kOwn);

}  // namespace microslip
