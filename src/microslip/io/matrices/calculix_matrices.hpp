// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices as CalculiX stores them by `*FREQUENCY, SOLVER=MATRIXSTORAGE`: JOB.sti and JOB.mas have
/// one triangle, a line `row column value` an entry; JOB.dof has a line `node.direction` a row.
/// Degrees of freedom that are fixed, or depend on others, are not among them.

namespace microslip {

/// One triangle of a matrix.
/// @param text  the file's whole text.
/// @param file  its name, for messages.
/// @param size  its rows.
/// @throws FormatError, InputError  as parse_matrix_market().
[[nodiscard]] SymmetricEntries parse_triangle(std::string_view text, std::string_view file,
                                              std::size_t size);

/// Degrees of freedom of the rows: one line per row, `12.3` or `12 3` or `12, z`, the directions 1
/// to 6 or x, y, z, rx, ry, rz; lines that begin with # are comments.
/// @throws FormatError  with line and column.
[[nodiscard]] std::vector<DegreeOfFreedom> parse_degrees(std::string_view text,
                                                         std::string_view file);

/// parse_degrees() of a file. @throws FileError, FormatError
[[nodiscard]] std::vector<DegreeOfFreedom> read_degrees(const std::string& path);

/// The three files of a job. @param job  their path without the ending.
/// @throws FileError, FormatError, InputError  also where two rows are of one degree of freedom, as
///         of shells and beams, and where there are more rows than degrees of freedom, as of a
///         cyclic sector.
[[nodiscard]] StructuralMatrices read_calculix_matrices(const std::string& job);

}  // namespace microslip
