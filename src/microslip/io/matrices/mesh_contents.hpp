// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "microslip/structure/meshed_structure.hpp"

/// @file
/// Contents of a mesh file: nodes, and named sets of them.

namespace microslip {

/// Nodes under a name.
struct NodeSet {
  std::string name;                 ///< as in the file; CalculiX does not tell capitals apart
  std::vector<std::int64_t> nodes;  ///< rising, each once
};

/// Nodes and sets of a mesh file.
struct MeshFile {
  std::vector<MeshNode> nodes;  ///< in the order of the file
  std::vector<NodeSet> sets;    ///< in the order of the file
};

}  // namespace microslip
