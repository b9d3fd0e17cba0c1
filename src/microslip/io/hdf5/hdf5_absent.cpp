// SPDX-License-Identifier: MIT

// In place of what needs the HDF5 library, see CMakeLists.txt.
#include "microslip/io/hdf5/hdf5_absent.hpp"

#include "microslip/base/error.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"

namespace microslip {

void refuse_hdf5(const std::string& path) {
  throw FileError(path, "is an HDF5 file, which this build of microslip does not support",
                  "Use another format, or build it with -DMICROSLIP_WITH_HDF5=ON.");
}

Recordings read_recordings_hdf5(const std::string& path, const RecordingReadOptions& /*options*/) {
  refuse_hdf5(path);
}

Hdf5Recordings read_hdf5_file(const std::string& path, const RecordingReadOptions& /*options*/) {
  refuse_hdf5(path);
}

void write_recordings_hdf5(const std::string& path, std::span<const Recording> /*recordings*/) {
  refuse_hdf5(path);
}

MatTree read_mat73_tree(const std::string& path, const MatReadOptions& /*options*/) {
  refuse_hdf5(path);
}

}  // namespace microslip
