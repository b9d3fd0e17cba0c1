// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices as Abaqus writes them with `*MATRIX OUTPUT` in its formats MATRIX INPUT, which is the
/// one it takes where none is named, and LABELS: a line an entry, of node, degree of freedom, node,
/// degree of freedom and value with commas between them. Internal to io.

namespace microslip {

/// Whether a text has such lines, above which only comments (`**`) and `*MATRIX INPUT` may stand.
/// @param head  its first lines.
[[nodiscard]] bool is_abaqus_matrix(std::string_view head);

/// is_abaqus_matrix() of a file. @throws FileError
[[nodiscard]] bool is_abaqus_matrix_file(const std::string& path);

/// The text of a file, and its name for messages.
struct AbaqusSource {
  std::string_view text;
  std::string file;
};

/// Rows are those that one of the two names, by node and degree of freedom. A symmetric matrix may
/// have one triangle or both.
/// @throws FormatError  with line and column: for what is no such line; for degrees of freedom
///     above 6. @throws InputError  for entries that are there twice or not symmetric, and where a
///     diagonal entry of the stiffness is missing.
[[nodiscard]] StructuralMatrices parse_abaqus_matrices(const AbaqusSource& stiffness,
                                                       const AbaqusSource& mass);

/// parse_abaqus_matrices() of files. @throws FileError
[[nodiscard]] StructuralMatrices read_abaqus_matrices(const std::string& stiffness,
                                                      const std::string& mass);

}  // namespace microslip
