// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings in HDF5 files.
///
/// Layout that is written:
///
///     /                schema = "microslip.recording/1"
///     /recording_1     source, axis_unit; start, step and, over time, fs = 1/step [Hz], where the
///                      points lie evenly
///       axis           the points where they do not; unit_str
///       channel_1 …    channel_name, unit_str (none: the unit is not known), quantity, fs
///     /recording_2 …
///
/// Names to the right are attributes, texts in UTF-8 or doubles, all in SI. Values are doubles;
/// complex ones are compounds {r, i}, as h5py and PyTables have them. The attributes of the
/// recording and of its channels stand beside these, one whose name cannot as
/// `attribute_<i>:<name>`. Datasets are cut into chunks of 1 MiB with a checksum each (fletcher32),
/// and what surrounds them is checksummed by the format itself (HDF5 1.10 and later): a changed
/// byte is found when it is read.
///
/// Layouts of other programs that are read: each group that contains numbers is a recording of the
/// datasets that share an axis. A dataset is a channel; one of two dimensions is as many as its
/// shorter side has. The axis is the dataset `time`, `t`, `frequency`, `freq` or `f` beside them
/// (`t` and `f` only where the values rise: else they are a channel, a force perhaps), or the
/// sampling rate (kRateNames: `fs`, `sampling_rate`, `SampleRate`, …) [Hz], or the interval
/// `dt`, `delta_t`, `sampling_interval` [s], with the time `t0` or `start` [s] of the first point:
/// an attribute of the dataset or of a group that it lies in, or a dataset of one number there.
/// `channel_name` names a channel (else the name of the dataset does), `unit_str`, `unit` or
/// `units` its unit. Values come in SI; without unit they are as the file has them. A damaged file
/// can crash the HDF5 library or keep it busy for ever, whoever wrote it; therefore another program
/// reads it, microslip-hdf5-reader, and hands over what it has read.

namespace microslip {

/// Reads all recordings of a file.
/// @throws FileError    where the file cannot be read.
/// @throws FormatError  where it is no HDF5 file, is damaged or cut short (even with
///                      allow_truncated: then its data cannot be reached), or contains no
///                      recording.
/// @throws InputError   where the sampling rate is missing, or check_recording() finds fault.
[[nodiscard]] Recordings read_recordings_hdf5(const std::string& path,
                                              const RecordingReadOptions& options = {});

/// Writes recordings to a file.
/// @param path        a staged name, see OutputFiles::stage(): it is written over.
/// @param recordings  written in their order.
/// @throws InputError  where check_recording() finds fault, or a text holds a zero byte.
/// @throws FileError   where the file cannot be written.
void write_recordings_hdf5(const std::string& path, std::span<const Recording> recordings);

}  // namespace microslip
