// SPDX-License-Identifier: MIT
#include "microslip/rig/rig_structure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace microslip {

ModalModel rig_modes(const Rig& rig, const StickState& state) {
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < state.modes(); ++i) {
    modes.push_back({state.omega[i], state.loss_factor[i]});
  }
  std::vector<ModalPoint> points{{rig.excitation.channel, state.excitation}};
  for (std::size_t i = 0; i < rig.accelerometers.size(); ++i) {
    points.push_back({rig.accelerometers[i].channel, state.accelerometer[i]});
  }
  return {std::move(modes), std::move(points)};
}

JointedStructure rig_structure(const Rig& rig, const StickState& state, Joint joint,
                               std::vector<std::complex<double>> force) {
  const double spring = state.stiffness > 0.0 ? state.stiffness : joint.stiffness();
  StructuralJoint contact{.name = std::string(kContact),
                          .joint = std::move(joint),
                          .shape = state.joint,
                          .spring_in_modes = spring,
                          .series_compliance = state.axial_compliance,
                          .shortening = state.shortening};
  return JointedStructure(rig_modes(rig, state), {std::move(contact)},
                          {{rig.excitation.channel, std::move(force)}}, DampingLaw::kHysteretic);
}

std::optional<Warning> stiffness_warning(const StickState& state, const Joint& joint) {
  constexpr double kMostDifference = 0.01;
  const double k = state.stiffness;
  if (k <= 0.0 || std::abs(joint.stiffness() / k - 1.0) <= kMostDifference) return std::nullopt;
  return Warning{"stiffness_differs",
                 fmt::format("The joint has k = {:.5g} N/m, the contact of the rig {:.5g} N/m, by "
                             "which its modes were computed. Give both the same.",
                             joint.stiffness(), k)};
}

}  // namespace microslip
