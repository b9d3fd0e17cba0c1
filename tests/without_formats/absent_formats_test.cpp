// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/io/hdf5/hdf5_contents.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/mat/mat_value.hpp"

namespace microslip::absent_formats_test {
namespace {

std::string message(const std::function<void()>& call) {
  try {
    call();
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(AbsentFormats, RefuseFilesOfHdf5) {
  const std::string refusal =
      "a.h5: is an HDF5 file, which this build of microslip does not support. Use another format, "
      "or "
      "build it with -DMICROSLIP_WITH_HDF5=ON.";
  EXPECT_EQ(message([] { (void)read_recordings_hdf5("a.h5"); }), refusal);
  EXPECT_EQ(message([] { write_recordings_hdf5("a.h5", {}); }), refusal);
  EXPECT_EQ(message([] { (void)read_mat73_tree("a.h5", {}); }), refusal);
  EXPECT_EQ(message([] { (void)joint_samples_bytes({}, "a.h5"); }), refusal);
  EXPECT_EQ(message([] { (void)read_joint_samples("a.h5"); }), refusal);
}

TEST(AbsentFormats, RefuseFilesOfMatlab) {
  const std::vector<std::function<void()>> calls{[] { (void)read_recordings_mat("a.mat", "", {}); },
                                                 [] { write_recordings_mat("a.mat", {}); },
                                                 [] { (void)read_mat_numbers("a.mat", "x"); },
                                                 [] { (void)read_mat_array("a.mat", "x"); },
                                                 [] { (void)read_mat_text("a.mat", "x"); },
                                                 [] { (void)mat_fields("a.mat", ""); },
                                                 [] { (void)mat_count("a.mat", "x"); },
                                                 [] { (void)mat73_tree("a.mat", {}); }};
  for (const auto& call : calls) {
    EXPECT_EQ(message(call),
              "a.mat: is a MATLAB file, which this build of microslip does not support. Use "
              "another format, or build it with -DMICROSLIP_WITH_MAT=ON.");
  }
}

}  // namespace
}  // namespace microslip::absent_formats_test
