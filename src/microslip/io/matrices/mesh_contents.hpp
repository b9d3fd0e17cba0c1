// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
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
  std::vector<MeshNode> nodes = {};              ///< in the order of the file
  std::vector<NodeSet> sets = {};                ///< in the order of the file
  std::vector<std::int64_t> element_nodes = {};  ///< of all its elements, rising, each once
  /// Nodes whose degrees of freedom 1 to 3 are rotations, rad: ROT NODE of *RIGID BODY, and the
  /// node of an *MPC MEANROT.
  std::vector<std::int64_t> rotation_nodes = {};
  bool axisymmetric = false;         ///< whether it has elements CAX…
  bool beside_axisymmetric = false;  ///< and others
  double own_unit = 1.0;  ///< of length, m, that the file itself gives; 1 where it gives none
  std::vector<Warning> warnings = {};  ///< on what other programs read otherwise
};

}  // namespace microslip
