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
/// more than it gains:
/// – atoms, at which the tangent jumps, where there are 16 at most: more small kinks are nearly a
///   smooth curve. Without cuts the order is 2.
/// – jumps, at which only the slope of the tangent does, where they and the atoms are 16 at most.
///   Without cuts the order is 3.
/// Internal to dynamics.
[[nodiscard]] std::vector<Corner> corners_of(const SlipDensity& density);

/// Slip forces of the atoms at which curves of harmonic balance have corners, N, rising: those of
/// more than 1/128 of the weight of all atoms of the density. Curves are followed past the others
/// without a stop, as past the segments of a piecewise linear density: a thousand atoms, as others
/// export their sliders, would be thousands of corners. Internal to dynamics.
[[nodiscard]] std::vector<double> heavy_atoms(const SlipDensity& density);

/// Whether a density of the structure has more than 16 atoms, at which no step is cut.
[[nodiscard]] bool has_many_atoms(const JointedStructure& structure);

}  // namespace microslip
