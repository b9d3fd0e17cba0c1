// SPDX-License-Identifier: MIT

// In place of what needs the HDF5 library, see CMakeLists.txt.

#include "microslip/base/error.hpp"
#include "microslip/io/ensemble_result_file.hpp"
#include "microslip/io/hdf5_reader.hpp"
#include "microslip/io/hdf5_recording.hpp"
#include "microslip/io/joint_samples_file.hpp"

namespace microslip {
namespace {

[[noreturn]] void refuse_hdf5(const std::string& path) {
  throw FileError(path, "is a file of HDF5, without which this microslip was built",
                  "Take another format, or build it with -DMICROSLIP_WITH_HDF5=ON.");
}

}  // namespace

Recordings read_recordings_hdf5(const std::string& path, const RecordingReadOptions& /*options*/) {
  refuse_hdf5(path);
}

void write_recordings_hdf5(const std::string& path, std::span<const Recording> /*recordings*/) {
  refuse_hdf5(path);
}

std::string joint_samples_bytes(const JointSamples& /*samples*/, const std::string& path) {
  refuse_hdf5(path);
}

JointSamples read_joint_samples(const std::string& path) { refuse_hdf5(path); }

void add_ensemble_result(const EnsembleResult& /*result*/,
                         const std::function<RowPass(std::size_t group)>& /*rows_of*/,
                         const std::string& path, OutputFiles& /*outputs*/) {
  refuse_hdf5(path);
}

MatTree read_mat73_tree(const std::string& path, const MatReadOptions& /*options*/) {
  refuse_hdf5(path);
}

}  // namespace microslip
