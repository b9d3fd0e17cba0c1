// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// A discretised structure with its supports, points, and joints between nodes or sets of nodes.

namespace microslip {

/// A vector of three components along x, y, z.
using Vector3 = std::array<double, 3>;

/// A node of the mesh.
struct MeshNode {
  std::int64_t number = 0;  ///< in the mesh
  Vector3 position = {};    ///< m
};

/// A direction along which, or an axis about which, something moves.
struct MeshDirection {
  Vector3 axis = {1.0, 0.0, 0.0};  ///< of length 1
  bool turns = false;              ///< about the axis, rad, in place of along it, m
};

/// Coupling of the nodes of a place.
enum class Spider : std::uint8_t {
  kAverage,  ///< none: the motion is that of the rigid body nearest to the nodes, and a force is
             ///< shared among them without stiffening anything
  kRigid,    ///< the nodes move as one rigid body
};

/// One or more nodes, or a row of the matrices.
struct MeshPlace {
  std::string name;                     ///< name in messages: "set 'left'", "node 12"
  std::vector<std::int64_t> nodes;      ///< each once; empty where `row` is given
  std::optional<std::size_t> row = {};  ///< of the matrices, from 0, in place of nodes
  Spider spider = Spider::kAverage;     ///< of two nodes or more
  /// Position on the body that the nodes form, m; their centre where it is left out.
  std::optional<Vector3> at = {};
};

/// Supported nodes.
struct MeshSupport {
  std::string name;                    ///< name in messages
  std::vector<std::int64_t> nodes;     ///< may be empty
  std::vector<std::size_t> rows = {};  ///< of the matrices, from 0
  /// Supported directions of the nodes, in the order of NodalDirection; directions they lack are
  /// ignored.
  std::array<bool, kNodalDirections> held = {true, true, true, true, true, true};
};

/// A named motion of the structure.
struct MeshPoint {
  std::string name;              ///< not empty; no two the same
  MeshPlace place;               ///< where
  MeshDirection direction = {};  ///< without meaning where the place is a row
};

/// A joint: the motion of `to` less that of `from`, or of the ground.
struct MeshJoint {
  std::string name;                    ///< not empty; no two the same
  std::optional<MeshPlace> from = {};  ///< the ground where it is left out
  MeshPlace to;                        ///< the other side
  MeshDirection direction = {};        ///< without meaning where both places are rows
  double stiffness = 0.0;              ///< k of the stuck joint, N/m (N m/rad where it turns); > 0
};

/// A motion of all supports, by 1 along a direction, and of the whole structure with them, as on a
/// shaker table. Joints and springs to the ground end on it.
struct MeshBase {
  std::string name;              ///< not empty; no two the same, and not that of a point
  MeshDirection direction = {};  ///< along it; without meaning where rows are given
  std::vector<std::size_t> rows =
      {};  ///< of the matrices, from 0, that move by 1; empty: by direction
};

/// The joints while modes are computed.
enum class JointsInModes : std::uint8_t {
  /// Absent: the modes are of the remaining structure, and a loss factor is of its material.
  kFree,
  kStuck,  ///< springs of their k: the modes, and losses, of a test at small amplitudes
};

/// The most modes of a model: more are no reduction.
inline constexpr std::size_t kMostModes = 5000;

/// A discretised structure with its supports, points, bases and joints.
struct MeshedStructure {
  StructuralMatrices matrices;             ///< without the joints
  std::vector<MeshNode> nodes = {};        ///< those whose position is known
  std::vector<MeshSupport> supports = {};  ///< supported nodes
  std::vector<MeshPoint> points = {};      ///< driven or measured motions
  std::vector<MeshBase> bases = {};        ///< that may be shaken
  std::vector<MeshJoint> joints = {};      ///< between places, or a place and the ground
  /// Nodes of rows that no element of the mesh has: incompatible modes, rotations and openings that
  /// a program numbers as translations of nodes, or nodes of elements that it has made.
  std::vector<std::int64_t> nodes_without_element = {};
};

}  // namespace microslip
