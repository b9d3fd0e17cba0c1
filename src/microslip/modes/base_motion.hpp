// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/modes/place_motion.hpp"

namespace microslip {

/// Motion of the rows of the matrices with a base.
struct BaseMotion {
  Eigen::VectorXd rows;               ///< r, one per row
  std::vector<bool> restrained = {};  ///< |K r| of a row is not 0
  std::size_t moved = 0;              ///< number of rows that move
  std::size_t strained = 0;           ///< and of those of them that are restrained
};

/// r of a base: 1 in the rows that it names; else in each row the component of its direction. Rows
/// of nodes that no element has may be no translations, whatever their number: those are left at
/// rest without which the strain energy rᵀKr is least, as a structure that translates has none;
/// of nodes that stiffness connects the least is sought a node at a time, from all of them and from
/// none.
/// @param stiffness  K of all rows, without joints.
/// @throws InputError  for a row that is not there, a rotation, or a direction without degrees of
///                     freedom.
[[nodiscard]] BaseMotion base_motion(const MeshRows& rows, const MeshedStructure& structure,
                                     const MeshBase& base,
                                     const Eigen::SparseMatrix<double>& stiffness);

/// Whether rows that are restrained outside of the matrices share mass with others.
[[nodiscard]] bool lacks_mass(const BaseMotion& base, const Eigen::SparseMatrix<double>& mass);

}  // namespace microslip
