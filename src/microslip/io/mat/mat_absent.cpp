// SPDX-License-Identifier: MIT

// In place of what reads and writes files of MATLAB, see CMakeLists.txt.
#include "microslip/io/mat/mat_absent.hpp"

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/hdf5/hdf5_contents.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/mat/mat_value.hpp"

namespace microslip {

void refuse_matlab(const std::string& path) {
  throw FileError(path, "is a MATLAB file, which this build of microslip does not support",
                  "Use another format, or build it with -DMICROSLIP_WITH_MAT=ON.");
}

Recordings read_recordings_mat(const std::string& path, std::string_view /*variable*/,
                               const RecordingReadOptions& /*options*/) {
  refuse_matlab(path);
}

Recordings read_recordings_mat(InputStream& file, std::string_view /*variable*/,
                               const RecordingReadOptions& /*options*/) {
  refuse_matlab(file.name());
}

Recordings read_recordings_mat73(const std::string& path, std::string_view /*variable*/,
                                 const RecordingReadOptions& /*options*/) {
  refuse_matlab(path);
}

Recordings read_recordings_hdf5_or_octave(const std::string& path,
                                          const RecordingReadOptions& options) {
  return read_recordings_hdf5(path, options);
}

void write_recordings_mat(const std::string& path, std::span<const Recording> /*recordings*/) {
  refuse_matlab(path);
}

MatTree mat73_tree(const std::string& path, const MatReadOptions& /*options*/) {
  refuse_matlab(path);
}

MatVariable::MatVariable(std::string path, std::string_view /*variable*/) : path_(std::move(path)) {
  refuse_matlab(path_);
}

MatVariable::MatVariable(InputStream& file, std::string_view /*variable*/) : path_(file.name()) {
  refuse_matlab(path_);
}

std::vector<double> MatVariable::numbers(std::string_view /*variable*/) const {
  refuse_matlab(path_);
}

MatArray MatVariable::array(std::string_view /*variable*/) const { refuse_matlab(path_); }

std::string MatVariable::text(std::string_view /*variable*/) const { refuse_matlab(path_); }

std::vector<std::string> MatVariable::fields(std::string_view /*variable*/) const {
  refuse_matlab(path_);
}

std::size_t MatVariable::count(std::string_view /*variable*/) const { refuse_matlab(path_); }

std::vector<double> read_mat_numbers(const std::string& path, std::string_view /*variable*/) {
  refuse_matlab(path);
}

MatArray read_mat_array(const std::string& path, std::string_view /*variable*/) {
  refuse_matlab(path);
}

std::string read_mat_text(const std::string& path, std::string_view /*variable*/) {
  refuse_matlab(path);
}

std::vector<std::string> mat_fields(const std::string& path, std::string_view /*variable*/) {
  refuse_matlab(path);
}

std::size_t mat_count(const std::string& path, std::string_view /*variable*/) {
  refuse_matlab(path);
}

}  // namespace microslip
