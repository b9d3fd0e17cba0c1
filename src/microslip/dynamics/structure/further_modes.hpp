// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// A static mode to be added to a structure, by the motion of its places; kg^−½ except for the
/// bases.
struct FurtherMode {
  Mode mode;                               ///< its frequency and loss factor
  std::vector<double> points = {};         ///< φ, one per point of the structure
  std::vector<double> joints = {};         ///< ψ, one per joint
  std::vector<double> participation = {};  ///< Γ, kg^½, one per base; empty: 0 of all
};

/// A structure with further static modes after its own. No joint is shortened by them.
/// @param structure  the structure.
/// @param modes      to be added; may be empty.
/// @throws InputError  as JointedStructure.
[[nodiscard]] JointedStructure with_further_modes(const JointedStructure& structure,
                                                  const std::vector<FurtherMode>& modes);

}  // namespace microslip
