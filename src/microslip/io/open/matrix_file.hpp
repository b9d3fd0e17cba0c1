// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/structure/structural_matrices.hpp"

namespace microslip {

/// A symmetric matrix of a file of Matrix Market, Harwell–Boeing, OUTPUT4 of Nastran (OP4), lines
/// of row, column and value, MATLAB (version 4, 5 or 7.3), Octave (text) or HDF5; internal to io.
/// @param path  FILE, or FILE:VARIABLE of OP4 and the latter three, see part_of_file(). These three
///              have the whole matrix, full or sparse.
/// @throws FileError, FormatError, InputError  as read_matrix_market(), read_harwell_boeing(),
///     read_op4(), read_coordinate_list(), read_mat_entries() and symmetric_of_both().
[[nodiscard]] SymmetricEntries read_matrix_file(const std::string& path);

}  // namespace microslip
