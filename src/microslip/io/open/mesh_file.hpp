// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/matrices/mesh_contents.hpp"

/// @file
/// Nodes of a mesh, and named sets of them.

namespace microslip {

/// Recognised by their content: an input of CalculiX or Abaqus (`*NODE`, `*NSET`, with GENERATE and
/// sets of sets, `*INCLUDE`; other keywords are passed over), a universal file (datasets 15 and
/// 2411, with the units of dataset 164), or a table with the columns `node [1], x [m], y [m], z
/// [m]`.
/// @param path         of the file; the files it includes are beside it.
/// @param length_unit  of one of the file, m, where it has no units.
/// @throws FileError, FormatError  with line and column; where it has no node and no set.
/// @throws InputError  where files include each other too deeply.
[[nodiscard]] MeshFile read_mesh(const std::string& path, double length_unit);

}  // namespace microslip
