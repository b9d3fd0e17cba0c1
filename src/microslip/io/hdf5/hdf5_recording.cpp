// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_recording.hpp"

#include <new>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"

namespace microslip {

Hdf5Recordings read_hdf5_file(const std::string& path, const RecordingReadOptions& options) {
  try {
    return read_hdf5_recordings(path, options);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "does not fit into memory");
  }
}

Recordings read_recordings_hdf5(const std::string& path, const RecordingReadOptions& options) {
  if (path == "-") throw FileError("standard input", "cannot hold an HDF5 file", "Name a file.");
  (void)read_file_head(path, 1);  // says what hinders the reading better than the library does
  Hdf5Recordings read = read_hdf5_file(path, options);
  if (!read.of_octave) return std::move(read.recordings);
  throw FormatError({.file = path}, "recordings", "variables of Octave's save -hdf5",
                    "In Octave: load it, and save -v7 FILE.");
}

}  // namespace microslip
