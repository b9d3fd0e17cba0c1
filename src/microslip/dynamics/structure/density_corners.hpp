// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/joint/density.hpp"

namespace microslip {

/// An atom of a density, or a jump.
struct Corner {
  double slip_force;  ///< N
  bool atom;
};

/// Slip forces at which steps of a march are cut, rising. To cut them at many places would cost
/// more than it gains: – atoms, at which the tangent jumps, where there are 16 at most: more small
/// kinks are nearly a
///   smooth curve. Without cuts the order is 2.
/// – jumps, at which only the slope of the tangent does, where they and the atoms are 16 at most.
///   Without cuts the order is 3.
/// Internal to dynamics.
[[nodiscard]] std::vector<Corner> corners_of(const SlipDensity& density);

/// Whether a density of the structure has more than 16 atoms, at which no step is cut.
[[nodiscard]] bool has_many_atoms(const JointedStructure& structure);

}  // namespace microslip
