// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip::testing {

/// A joint between two masses of a chain; from −1 it is one to the ground.
struct ChainJoint {
  std::string name;
  int from;
  int to;
  Joint joint;
};

/// Masses in a row with linear springs between neighbours, the first and the last held by springs
/// too, and joints between some of them. Modes by a dense eigensolver, of the stuck structure; the
/// force is on the first mass. Points are "p1", "p2", …
/// @param mass     kg, one a mass.
/// @param spring   N/m, one more than masses.
/// @param stuck    stiffness of each joint in the modes, N/m: usually its k.
JointedStructure chain_structure(const std::vector<double>& mass, const std::vector<double>& spring,
                                 const std::vector<ChainJoint>& joints, double loss_factor,
                                 const std::vector<double>& stuck);

}  // namespace microslip::testing
