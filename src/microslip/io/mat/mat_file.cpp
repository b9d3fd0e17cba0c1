// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_file.hpp"

#include <cstddef>
#include <new>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/mat/mat4_reader.hpp"
#include "microslip/io/mat/mat5_reader.hpp"
#include "microslip/io/mat/mat_stream.hpp"
#include "microslip/io/mat/octave_text_reader.hpp"

namespace microslip {
namespace {

constexpr std::size_t kHeadSize = 520;
constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1A\n";

MatTree read_any_version(InputStream& opened, const MatReadOptions& options) {
  const std::string& path = opened.name();
  MatFileStream file(opened, options.progress);
  const std::string head = file.head(kHeadSize);
  if (head.starts_with(kHdf5Signature) ||
      (head.size() == kHeadSize && head.ends_with(kHdf5Signature))) {
    return read_mat73_tree(path, options);
  }
  if (head.starts_with("# Created by Octave")) {
    return parse_octave_text(read_rest_of_text(opened), path, options);
  }
  if (head.starts_with("MATLAB 5.0") ||
      (head.size() >= 128 && (head.substr(126, 2) == "IM" || head.substr(126, 2) == "MI"))) {
    return read_mat5(file, options);
  }
  if (signature(head) == "a MAT file of version 4") return read_mat4(file, options);
  throw FormatError({.file = path}, "a MAT file of MATLAB, version 4, 5 or 7.3",
                    head.empty() ? "nothing" : "a file that starts " + in_quotes(head, 20),
                    "In MATLAB: save('name.mat', ..., '-v7').");
}

}  // namespace

MatTree read_mat_tree(const std::string& path, const MatReadOptions& options) {
  if (path == "-") throw FileError("standard input", "cannot hold a MAT file", "Name a file.");
  InputStream file(path);
  return read_mat_tree(file, options);
}

MatTree read_mat_tree(InputStream& file, const MatReadOptions& options) {
  try {
    return read_any_version(file, options);
  } catch (const std::bad_alloc&) {
    throw FileError(file.name(), "does not fit into memory");
  }
}

}  // namespace microslip
