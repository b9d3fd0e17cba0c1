// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/jointed_structure.hpp"
#include "microslip/rig/rig_structure.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

/// @file Structures whose vibration is known from elsewhere.

namespace microslip::testing {

/// A mass of 1 kg on a spring of 0.75 N/m with a damper of 0.01 N s/m and a joint.
inline JointedStructure one_mass(Joint joint, double spring = 0.75, double damper = 0.01) {
  const double omega = std::sqrt(spring);
  ModalModel linear({{omega, damper / omega}}, {{"mass", {1.0}}});
  return JointedStructure(std::move(linear), {{"joint", std::move(joint), {1.0}}}, {{"mass"}});
}

/// Segalman's joint and a Jenkins element, 0.25 N/m both, macro-slip at 0.2 N.
inline Joint iwan_joint() { return Joint::four_parameter(0.2, 0.25, -0.5, 0.0); }
inline Joint jenkins_joint() { return Joint(0.25, SlipDensity({AtomsPart{{0.2}, {1.0}}})); }

/// Joints of a kind each: atoms, a power law, uniform with an elastic remainder, piecewise linear.
inline std::vector<Joint> joints_of_each_kind() {
  return {jenkins_joint(), iwan_joint(), Joint(1.0, SlipDensity({UniformPart{0.0, 0.5, 0.9}})),
          Joint(2.0, SlipDensity({PiecewiseLinearPart{{0.0, 0.1, 0.5}, {1.0, 2.5, 1.0}}}))};
}

/// The reference rig with the joint of reference_rig_levels.csv; driven at the point "force".
inline JointedStructure friction_rig(std::size_t modes = 7) {
  const Rig rig = reference_rig();
  return rig_structure(rig, stick_state(rig, modes), reference_joint());
}

/// Modes and joints of four-parameter densities or of atoms, driven at "a"; seen there or at "b".
inline JointedStructure random_structure(std::uint64_t seed, std::uint64_t stream,
                                         std::size_t count, std::size_t joint_count) {
  RandomStream random(seed, stream);
  const auto uniform = [&] { return 2.0 * random.uniform() - 1.0; };
  std::vector<Mode> modes;
  std::vector<double> a;
  std::vector<double> b;
  double omega = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    modes.push_back({omega, std::pow(10.0, -3.0 + 1.5 * random.uniform())});
    omega *= 1.1 + 1.5 * random.uniform();
    a.push_back(uniform());
    b.push_back(uniform());
  }
  std::vector<StructuralJoint> joints;
  for (std::size_t j = 0; j < joint_count; ++j) {
    std::vector<double> shape;
    for (std::size_t i = 0; i < count; ++i) shape.push_back(uniform());
    const double k = 0.3 + 2.0 * random.uniform();
    const double slip = 0.2 * random.uniform() + 0.02;
    const double beta = seed % 4 == 1 ? 1.0 + random.uniform() : 0.0;
    const Joint joint = seed % 4 == 3
                            ? Joint(k, SlipDensity({AtomsPart{{slip, 2.0 * slip}, {0.6, 0.4}}}))
                            : Joint::four_parameter(slip, k, -0.9 * random.uniform(), beta);
    joints.push_back({.name = "joint " + std::to_string(j), .joint = joint, .shape = shape});
  }
  return JointedStructure(ModalModel(modes, {{"a", a}, {"b", b}}), std::move(joints), {{"a"}});
}

}  // namespace microslip::testing
