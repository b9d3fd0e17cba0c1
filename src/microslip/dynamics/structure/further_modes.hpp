// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// A static mode that a structure has not yet, by what moves in it; kg^−½ but for the bases.
struct FurtherMode {
  Mode mode;                               ///< its frequency and loss factor
  std::vector<double> points = {};         ///< φ, one a point of the structure
  std::vector<double> joints = {};         ///< ψ, one a joint
  std::vector<double> participation = {};  ///< Γ, kg^½, one a base; empty: 0 of all
};

/// A structure with further static modes behind the modes it has. No joint is shortened by them.
/// @param structure  as it is.
/// @param modes      to be added; none leaves it so.
/// @throws InputError  as JointedStructure.
[[nodiscard]] JointedStructure with_further_modes(const JointedStructure& structure,
                                                  const std::vector<FurtherMode>& modes);

}  // namespace microslip
