// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices as Nastran punches them: entries DMIG by grid points and components, as of
/// `PARAM,EXTOUT,DMIGPCH`, which writes KAAX and MAAX. Internal to io.

namespace microslip {

/// Where a matrix is.
struct DmigSource {
  std::string_view text;  ///< of the file
  std::string file;       ///< its name, for messages
  std::string name = {};  ///< of the matrix; empty: the only one whose name begins with `initial`
  char initial = 'K';     ///< K of a stiffness, M of a mass
};

/// Whether a text has an entry DMIG. @param head  its first lines.
[[nodiscard]] bool is_dmig(std::string_view head);

/// is_dmig() of a file. @param path  FILE or FILE:NAME. @throws FileError
[[nodiscard]] bool is_dmig_file(const std::string& path);

/// Rows are those that one of the two names, by point and component. A component of 0, of a scalar
/// point, is taken for a translation in x.
/// @throws FormatError  with line and column: for what is no number; for components above 6.
/// @throws InputError   for a matrix that is not there, or one of several that none is chosen of;
///                      that is rectangular, complex, not symmetric, or cut, by name.
[[nodiscard]] StructuralMatrices parse_dmig_matrices(const DmigSource& stiffness,
                                                     const DmigSource& mass);

/// parse_dmig_matrices() of files. @param stiffness, mass  FILE or FILE:NAME. @throws FileError
[[nodiscard]] StructuralMatrices read_dmig_matrices(const std::string& stiffness,
                                                    const std::string& mass);

}  // namespace microslip
