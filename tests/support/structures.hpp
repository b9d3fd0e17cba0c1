// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

/// @file Structures whose vibration is known from elsewhere.

namespace microslip::testing {

/// A mass of 1 kg on a spring of 0.75 N/m with a damper of 0.01 N s/m and a joint.
JointedStructure one_mass(Joint joint, double spring = 0.75, double damper = 0.01);

/// Segalman's joint and a Jenkins element, 0.25 N/m both, macro-slip at 0.2 N.
Joint iwan_joint();
Joint jenkins_joint();

/// Joints of a kind each: atoms, a power law, uniform with an elastic remainder, piecewise linear.
std::vector<Joint> joints_of_each_kind();

/// The reference rig with the joint of reference_rig_levels.csv; driven at the point "force".
JointedStructure friction_rig(std::size_t modes = 7);

/// Modes and joints of four-parameter densities or of atoms, driven at "a"; observed there or at
/// "b".
JointedStructure random_structure(std::uint64_t seed, std::uint64_t stream, std::size_t count,
                                  std::size_t joint_count);

}  // namespace microslip::testing
