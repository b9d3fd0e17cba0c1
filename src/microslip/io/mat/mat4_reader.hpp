// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/mat/mat_stream.hpp"
#include "microslip/io/recordings/mat_tree.hpp"

namespace microslip {

/// Reads a MAT file of version 4 [MathWorks, MAT-File Format, R2019b, chapter 2] from its start:
/// matrices of numbers and texts, and sparse ones, of either byte order.
/// @throws FormatError  where it is damaged, or has numbers of a VAX or a Cray.
[[nodiscard]] MatTree read_mat4(MatFileStream& file, const MatReadOptions& options);

}  // namespace microslip
