// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/mat/mat_stream.hpp"
#include "microslip/io/recordings/mat_tree.hpp"

namespace microslip {

/// Reads the variables of a file of level 5 [MathWorks, MAT-File Format, R2019b, chapter 1], of
/// either byte order, compressed or not. Each element is checked to lie within the one around it
/// and to have as many values as its sizes say, and the checksum of compressed ones is compared,
/// before anything is made of them.
/// @param file  at its start.
[[nodiscard]] MatTree read_mat5(MatFileStream& file, const MatReadOptions& options);

}  // namespace microslip
