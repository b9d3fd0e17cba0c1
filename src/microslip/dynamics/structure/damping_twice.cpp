// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/damping_twice.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
#include <span>
#include <string>

namespace microslip {
namespace {

constexpr double kLeastShare = 0.9;  // of the stiffness of the mode
constexpr double kAlike = 2.0;

std::string warning_text(const StructuralJoint& joint, std::size_t mode, double loss_factor,
                         double of_joint) {
  return fmt::format(
      "mode {} has a loss factor of {:.4g}, and joint '{}', which is its stiffness, gives it "
      "{:.4g} "
      "by a linear damping of {:.5g} J/m^2: if they are the same loss, it counts twice. Remove "
      "the damping of the mode, or that of the joint.",
      mode + 1, loss_factor, joint.name, of_joint, joint.linear_damping);
}

}  // namespace

std::vector<Warning> damping_twice(const JointedStructure& structure) {
  std::vector<Warning> warnings;
  const std::span<const Mode> modes = structure.linear().modes();
  for (const StructuralJoint& joint : structure.joints()) {
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const double stiffness = modes[i].angular_frequency * modes[i].angular_frequency;
      const double square = joint.shape[i] * joint.shape[i];
      if (!(joint.spring_in_modes * square >= kLeastShare * stiffness) || stiffness == 0.0)
        continue;
      const double of_joint = joint.linear_damping * square / (std::numbers::pi * stiffness);
      const double of_mode = modes[i].loss_factor;
      const bool alike = of_mode <= kAlike * of_joint && of_joint <= kAlike * of_mode;
      if (!alike || of_mode == 0.0) continue;
      warnings.push_back({"damping_twice", warning_text(joint, i, of_mode, of_joint)});
    }
  }
  return warnings;
}

}  // namespace microslip
