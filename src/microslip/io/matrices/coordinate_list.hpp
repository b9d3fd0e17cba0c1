// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices as lines of row, column and value without a header, as of `*MATRIX OUTPUT,
/// FORMAT=COORDINATE` of Abaqus and of MATLAB's `[i,j,v] = find(K)`. Internal to io.

namespace microslip {

/// @param head  the first lines of a file.
[[nodiscard]] bool is_coordinate_list(std::string_view head);

/// A matrix of as many rows as the largest row or column of an entry. Symmetric: of both triangles
/// where any entry has one across the diagonal, else of one; entries of one place add up. A first
/// line of rows, columns and the number of lines behind it is no entry; comments begin with % or #.
/// @param file  its name, for messages.
/// @throws FormatError  with line and column. @throws InputError  where it is not symmetric.
[[nodiscard]] SymmetricEntries parse_coordinate_list(std::string_view text, std::string_view file);

/// parse_coordinate_list() of a file. @throws FileError
[[nodiscard]] SymmetricEntries read_coordinate_list(const std::string& path);

}  // namespace microslip
