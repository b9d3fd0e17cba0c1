// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/mat_stream.hpp"
#include "microslip/io/mat_tree.hpp"

namespace microslip {

/// Reads the variables of a file of level 4 [MathWorks, MAT-File Format, R2019b, chapter 2], of IEEE
/// numbers in either byte order: matrices of numbers and text.
/// @param file  at its start.
[[nodiscard]] MatTree read_mat4(MatFileStream& file, const MatReadOptions& options);

/// Could a file that starts with these bytes be of level 4?
[[nodiscard]] bool is_mat4(std::string_view head);

}  // namespace microslip
