// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/matrices/mesh_contents.hpp"

namespace microslip {

/// Nodes and sets of an input of CalculiX or Abaqus, see read_mesh(). Internal to io.
/// @param file  whose folder is that of the files it includes.
[[nodiscard]] MeshFile parse_mesh_input(std::string_view text, const std::string& file,
                                        double length_unit);

}  // namespace microslip
