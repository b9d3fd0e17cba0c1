// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/structure/meshed_structure.hpp"

namespace microslip {

/// The object that messages name for rows.
enum class RowsOf : std::uint8_t { kMatrices, kTest };

/// The degrees of freedom of the rows of the matrices, and the positions of the nodes.
class MeshRows {
 public:
  /// @param structure  must outlive this object.
  /// @param rows_of    for messages; the rows of a test are its measured degrees of freedom.
  /// @throws InputError  where two rows are of one degree of freedom and the matrices are not
  ///                     expanded, two nodes of one number, or the number of rows differs from the
  ///                     given one.
  explicit MeshRows(const MeshedStructure& structure, RowsOf rows_of = RowsOf::kMatrices);

  /// n.
  [[nodiscard]] std::size_t size() const;
  /// The rows of a degree of freedom: one, or of expanded matrices several.
  /// @throws InputError  naming the place, the node and the directions that it has.
  [[nodiscard]] std::vector<std::size_t> rows_of(const std::string& place, std::int64_t node,
                                                 NodalDirection direction) const;
  /// All rows of a node, with their directions. @throws InputError  where it has none.
  [[nodiscard]] std::vector<std::pair<NodalDirection, std::size_t>> rows(const std::string& place,
                                                                         std::int64_t node) const;
  /// A row counted from 0. @throws InputError  where there is none.
  [[nodiscard]] std::size_t checked(const std::string& place, std::size_t row) const;
  /// "row 7", or "node 12 x".
  [[nodiscard]] std::string name(std::size_t row) const;
  /// m. @throws InputError  naming the place, where it is not known.
  [[nodiscard]] Eigen::Vector3d position(const std::string& place, std::int64_t node) const;

 private:
  /// "nodes 1 to 5", or those there are about a number that is none.
  [[nodiscard]] std::string nodes_near(std::int64_t node) const;

  const MeshedStructure& structure_;
  RowsOf rows_of_;
  std::multimap<DegreeOfFreedom, std::size_t> rows_;
  std::unordered_map<std::int64_t, std::size_t> nodes_;
};

/// A motion as a weighted sum of the degrees of freedom; a force on it is shared by the same
/// weights.
using Motion = std::vector<std::pair<std::size_t, double>>;

/// The motion of a place: along d of the point p of the body that its nodes form, of centre c,
///
///     d·ū + θ·((p − c) × d),   ū = mean of u_i,   θ = I⁻¹ Σ s_i × u_i,   I = Σ (|s_i|² − s_i s_iᵀ)
///
/// with s_i = r_i − c: the rigid motion nearest to those of the nodes in the sense of least
/// squares; about an axis a, a·θ. Of one node, θ is its own rotation.
/// @throws InputError  naming the place and the node or degree of freedom that is missing; where
///                     nodes on one line do not determine a rotation.
[[nodiscard]] Motion place_motion(const MeshRows& rows, const MeshPlace& place,
                                  const MeshDirection& direction);

/// The motion of `to` less that of `from`. @throws InputError  as place_motion().
[[nodiscard]] Motion joint_motion(const MeshRows& rows, const MeshJoint& joint);

/// The centre of nodes and their arms s_i from it, m; 3 × nodes.
struct NodeArms {
  Eigen::Vector3d centre;
  Eigen::Matrix3Xd arms;
};
/// @throws InputError  where the position of a node is not known.
[[nodiscard]] NodeArms node_arms(const MeshRows& rows, const MeshPlace& place);

}  // namespace microslip
