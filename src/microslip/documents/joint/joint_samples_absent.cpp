// SPDX-License-Identifier: MIT
// In place of what needs the HDF5 library, see CMakeLists.txt.
#include "microslip/documents/joint/joint_samples_file.hpp"

#include "microslip/io/hdf5/hdf5_absent.hpp"

namespace microslip {

std::string joint_samples_bytes(const JointSamples& /*samples*/, const std::string& path) {
  refuse_hdf5(path);
}

JointSamples read_joint_samples(const std::string& path) { refuse_hdf5(path); }

}  // namespace microslip
