// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings in MAT files of MATLAB.
///
/// Layout that is written: a struct for each recording, recording_1, recording_2, …, with the
/// fields
///
///     schema      'microslip.recording/1'
///     source      text
///     axis_unit   text, SI
///     fs          1/step [Hz], over time only   ⎫ where the points
///     start       of the first point            ⎬ lie evenly
///     step        from each point to the next   ⎭
///     axis        the points where they do not, a column
///     attributes  a cell of n × 2 texts, names and values
///     channels    a 1 × n struct: name, unit (SI; '' where it is not known), quantity, values
///                 (a column, complex or real), attributes
///
/// all in SI; version 5 without compression, which MATLAB, SciPy and Octave read. It holds
/// recordings below 2 GiB.
///
/// Layouts of other programs that are read (version 5 and 7.3): a struct, or the variables at the
/// top, with vectors and
///   the points `time` or `t` [s], `frequency`, `freq` or `f` [Hz] (`t` and `f` only where the
///   values rise: else they are a channel, a force perhaps),
///   or the sampling rate `fs`, `Fs`, `sampling_rate` [Hz] or interval `dt` [s], and `t0` or
///   `start`; those at the top of the file hold inside as well.
/// A vector is a channel; so is each column of a matrix (of a row where that is the longer side),
/// with the names in the cell `names`, `channel_names` or `labels`; so is a struct with `values` or
/// `data`, `name` and `unit`, or `Data`, `Name` and `Unit` (dSPACE). Other structs are looked into,
/// each element of an array by itself.
/// `units` (`unit`, `unit_str`) has a text for all channels; a cell, or a list between commas or
/// semicolons, of one for each array of its struct, one for each channel (behind that of the axis
/// or without it), one for the axis and one for all channels, or one for each quantity that the
/// names tell; or a struct of one for each array. NAME_unit is that of the array NAME. A list that
/// fits none of these gives a warning. Without unit, values are as the file has them.
/// Version 7.3 is read in a process of its own, see hdf5_recording.hpp.

namespace microslip {

class InputStream;

/// Reads the recordings of a file, or of a part of it.
/// @param path      of the file.
/// @param variable  a struct or a vector, written as in mat_value.hpp; empty: all of the file.
/// @param options   see RecordingReadOptions.
/// @throws FileError    where the file cannot be read.
/// @throws FormatError  where it is no MAT file, is damaged, or holds no recording. Of a file cut
///                      short, allow_truncated takes the variables that are whole (not in 7.3).
/// @throws InputError   where the variable or the sampling rate is missing, or check_recording()
///                      finds fault.
[[nodiscard]] Recordings read_recordings_mat(const std::string& path,
                                             std::string_view variable = {},
                                             const RecordingReadOptions& options = {});

/// As above, of a file that is open, of which nothing was taken. Version 7.3 is opened again, by
/// the process that reads it.
[[nodiscard]] Recordings read_recordings_mat(InputStream& file, std::string_view variable,
                                             const RecordingReadOptions& options);

/// As above, of a file that is known to be of version 7.3: it is opened once.
[[nodiscard]] Recordings read_recordings_mat73(const std::string& path, std::string_view variable,
                                               const RecordingReadOptions& options);

/// Reads the recordings of an HDF5 file that could be opened, as read_recordings_hdf5(); of
/// variables that Octave wrote (save -hdf5) as of those of a MAT file.
/// @throws  as these.
[[nodiscard]] Recordings read_recordings_hdf5_or_octave(const std::string& path,
                                                        const RecordingReadOptions& options);

/// Writes recordings to a file.
/// @param path        a staged name, see OutputFiles::stage(): it is written over.
/// @param recordings  written in their order.
/// @throws InputError  where check_recording() finds fault, a text is not UTF-8, or a recording is
///                     too large.
/// @throws FileError   where the file cannot be written.
void write_recordings_mat(const std::string& path, std::span<const Recording> recordings);

}  // namespace microslip
