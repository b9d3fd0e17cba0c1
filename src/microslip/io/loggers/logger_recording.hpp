// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/recordings/recordings.hpp"

/// @file
/// Recordings in files of data loggers. They are read, not written.

namespace microslip {

/// Reads a TDMS file of LabVIEW (NI, "The NI TDMS File Format", version 2.0): numbers of any type
/// and byte order, interleaved or not, and those of DAQmx, scaled as the file states (linear,
/// polynomial, table, add, subtract). Each group is a recording; channels of another scale, of
/// texts or complex numbers are left out with a warning.
///
/// Over what values are: `wf_increment` [s] (or in `wf_xunit_string`, Hz for a spectrum) from
/// `wf_start_offset` on, and `wf_start_time` where the channels of a group do not begin together:
/// the earliest is at 0. Those that begin whole steps apart are cut to what they have in common,
/// with a warning. Else the channel `Time`, `time` or `t` or one of time stamps beside them, or the
/// sampling rate among the properties of channel, group or file (sampling.hpp). The unit is
/// `unit_string` or `NI_UnitDescription`.
/// @throws FileError    where the file cannot be read.
/// @throws FormatError  where it is damaged or holds no recording; where its last segment is not
///                      whole, unless the options allow that.
/// @throws InputError   where check_recording() finds fault.
[[nodiscard]] Recordings read_recordings_tdms(const std::string& path,
                                              const RecordingReadOptions& options = {});

/// Reads a WAV file (RIFF, RIFX, RF64, BW64): integers of 8 to 32 bits, as fractions of full scale,
/// and floating-point numbers. Channels are called channel_1, channel_2, … and have no unit.
/// @throws  as read_recordings_tdms().
[[nodiscard]] Recordings read_recordings_wav(const std::string& path,
                                             const RecordingReadOptions& options = {});

/// Reads an LVM file of LabVIEW ("Specification for the LabVIEW Measurement File"): each of its
/// sections is a recording over `Delta_X` from `X0` on, or over the column of its x, by `Delta_X`
/// where that explains the printed x. Names and `Y_Unit_Label` are those of its header, for the
/// channel that they stand at. Sections that go on where the last one ended are appended to it.
/// Channels of a section that begin at another `Date` and `Time` are recordings of their own, later
/// by that, with a warning; those over something else than time or frequency are left out with one.
/// @throws  as read_recordings_tdms().
[[nodiscard]] Recordings read_recordings_lvm(const std::string& path,
                                             const RecordingReadOptions& options = {});

}  // namespace microslip
