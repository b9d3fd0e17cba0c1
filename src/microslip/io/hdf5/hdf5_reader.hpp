// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/progress.hpp"
#include "microslip/io/hdf5/hdf5_joint_samples.hpp"
#include "microslip/io/recordings/mat_tree.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/io/sandbox/parcel.hpp"

/// @file
/// The program microslip-hdf5-reader, which reads files of HDF5 for the library: a damaged file can
/// crash the HDF5 library or keep it busy for ever. What stands in hdf5_contents.hpp happens there.

namespace microslip {

/// Its path: that of the environment variable MICROSLIP_HDF5_READER; else the first that is there:
/// in the folder of the running program or the one above it, in ../libexec/microslip of that
/// folder, of the shared library's or of the one above that, where this library was installed.
/// @throws FileError  where it is nowhere.
[[nodiscard]] std::string find_hdf5_reader();

/// What a file holds: recordings, or variables of Octave, of which other functions make recordings.
struct Hdf5Recordings {
  Recordings recordings = {};
  MatTree variables = {};
  bool of_octave = false;
};

template <class Parcel>
void pass(Parcel& parcel, Hdf5Recordings& read) {
  pass(parcel, read.recordings);
  pass(parcel, read.variables);
  char of_octave = read.of_octave ? 1 : 0;
  pass(parcel, of_octave);
  read.of_octave = of_octave != 0;
}

/// hdf5_recordings() there. @throws  as run_reading_process().
[[nodiscard]] Hdf5Recordings read_hdf5_recordings(const std::string& path,
                                                  const RecordingReadOptions& options);

/// The same, of a file that could be opened.
/// @throws FileError, FormatError, InputError  as read_recordings_hdf5().
[[nodiscard]] Hdf5Recordings read_hdf5_file(const std::string& path,
                                            const RecordingReadOptions& options);

/// hdf5_joint_samples() there. @throws  as run_reading_process().
[[nodiscard]] RawSamples read_hdf5_joint_samples(const std::string& path);

/// mat73_tree() there. @throws  as run_reading_process().
[[nodiscard]] MatTree read_mat73_tree(const std::string& path, const MatReadOptions& options);

}  // namespace microslip
