// SPDX-License-Identifier: MIT
#include "support/structures.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace microslip::testing {

JointedStructure one_mass(Joint joint, double spring, double damper) {
  const double omega = std::sqrt(spring);
  ModalModel linear({{omega, damper / omega}}, {{"mass", {1.0}}});
  return JointedStructure(std::move(linear), {{"joint", std::move(joint), {1.0}}}, {{"mass"}});
}

Joint iwan_joint() { return Joint::four_parameter(0.2, 0.25, -0.5, 0.0); }

Joint jenkins_joint() { return Joint(0.25, SlipDensity({AtomsPart{{0.2}, {1.0}}})); }

std::vector<Joint> joints_of_each_kind() {
  return {jenkins_joint(), iwan_joint(), Joint(1.0, SlipDensity({UniformPart{0.0, 0.5, 0.9}})),
          Joint(2.0, SlipDensity({PiecewiseLinearPart{{0.0, 0.1, 0.5}, {1.0, 2.5, 1.0}}}))};
}

JointedStructure friction_rig(std::size_t modes) {
  const Rig rig = reference_rig();
  return rig_structure(rig, stick_state(rig, modes), reference_joint());
}

JointedStructure random_structure(std::uint64_t seed, std::uint64_t stream, std::size_t count,
                                  std::size_t joint_count) {
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
