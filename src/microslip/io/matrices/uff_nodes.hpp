// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/matrices/mesh_contents.hpp"

namespace microslip {

/// Nodes of datasets 15 (4I10, 3E13) and 2411 (4I10, then 3D25) of a universal file, see
/// read_mesh(). Internal to io.
[[nodiscard]] MeshFile read_uff_nodes(const std::string& path, double length_unit);

}  // namespace microslip
