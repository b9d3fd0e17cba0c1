// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <string>
#include <vector>

#include "microslip/modes/vibrating_system.hpp"
#include "microslip/structure/meshed_structure.hpp"

namespace microslip {

/// The system whose modes are sought. With x = T z, T of the free degrees of freedom and of the
/// rigid bodies that spiders make of nodes, K = Tᵀ K T and M = Tᵀ M T.
struct AssembledSystem {
  VibratingSystem system;              ///< its springs are none yet
  Eigen::SparseMatrix<double> points;  ///< the motion of each point in z, a column each
  Eigen::SparseMatrix<double> joints;  ///< motion of each joint, `to` less `from`
  Eigen::MatrixXd base_loads;          ///< Tᵀ M r of each base, a column each, kg
  Eigen::VectorXd base_masses;         ///< rᵀ M r of each, kg
  Eigen::MatrixXd base_motions;        ///< r at each point, points × bases
  /// For each base: whether rows restrained outside of the matrices, |Tᵀ K r| where it should be 0,
  /// share mass with other degrees of freedom, whose part there is not in the matrices.
  std::vector<bool> base_mass_missing;
  /// For each base: how many rows move by it, of how many of them |K r| is not 0, and the share of
  /// the latter in rᵀ M r, 1.
  struct MovedRows {
    std::size_t moved;
    std::size_t strained;
    double strained_mass;
  };
  std::vector<MovedRows> base_rows;
  /// Rows with mass and without stiffness that no joint, support or rigid spider holds.
  struct LooseRows {
    std::size_t count = 0;
    std::string first = {};  ///< name of the first, "node 9 x"
  };
  LooseRows loose_rows = {};
};

/// @throws InputError  naming what is wrong: matrices that are empty, of different sizes, with
///                     entries outside or not finite; a mass matrix with a negative eigenvalue; a
///                     degree of freedom without stiffness and mass; a node, row or position that
///                     is missing; nodes in two rigid bodies, or in one and fixed; names that are
///                     empty or the same; a point or joint that does not move.
[[nodiscard]] AssembledSystem assemble_system(const MeshedStructure& structure);

}  // namespace microslip
