// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/mat_tree.hpp"

namespace microslip {

/// Reads the variables of a file of version 7.3: an HDF5 file in which structs are groups, cells
/// are references into /#refs#, and the attribute MATLAB_class says what each dataset is.
[[nodiscard]] MatTree read_mat73(const std::string& path, const MatReadOptions& options);

}  // namespace microslip
