// SPDX-License-Identifier: MIT
// In place of what reads files of MATLAB, see CMakeLists.txt.
#include "microslip/io/matrices/mat_entries.hpp"

#include "microslip/io/mat/mat_absent.hpp"

namespace microslip {

MatrixEntries read_mat_entries(const std::string& path, std::string_view /*variable*/) {
  refuse_matlab(path);
}

}  // namespace microslip
