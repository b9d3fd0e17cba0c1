// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/rig_structure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "microslip/base/error.hpp"

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

namespace {

/// Checks modes given with rounding: without the joint no mode may have a negative stiffness, which
/// is kΣψ_i²/ω_i² ≤ 1.
void check_modes_hold(const Rig& rig, const StickState& state, double spring) {
  if (!rig.modes()) return;
  double flexibility = 0.0;
  for (std::size_t i = 0; i < state.modes(); ++i) {
    flexibility += state.joint[i] * state.joint[i] / (state.omega[i] * state.omega[i]);
  }
  const double share = spring * flexibility;
  if (!(share > 1.0)) return;
  constexpr double kRounding = 1.01;  // of k by digits that were typed in
  throw InputError(
      "modes.joint", fmt::format("[{:.6g}]", fmt::join(state.joint, ", ")),
      fmt::format("must leave the structure some stiffness without the joint: with frequency_Hz it "
                  "belongs to a joint of {:.6g} N/m at most, and k is {:.6g} N/m",
                  1.0 / flexibility, spring),
      share > kRounding
          ? "Check k, the shape and the frequency."
          : fmt::format("If the joint is the only stiffness, this is rounding: make the "
                        "shape at the joint {:.2g} % smaller. Otherwise check k, the shape and the "
                        "frequency.",
                        110.0 * (1.0 - 1.0 / std::sqrt(share))));
}

}  // namespace

JointedStructure rig_structure(const Rig& rig, const StickState& state, Joint joint,
                               std::vector<std::complex<double>> force, double linear_damping) {
  const double spring = state.stiffness > 0.0 ? state.stiffness : joint.stiffness();
  check_modes_hold(rig, state, spring);
  StructuralJoint contact{.name = std::string(kContact),
                          .joint = std::move(joint),
                          .shape = state.joint,
                          .spring_in_modes = spring,
                          .series_compliance = state.axial_compliance,
                          .shortening = state.shortening,
                          .linear_damping = linear_damping};
  return JointedStructure(rig_modes(rig, state), {std::move(contact)},
                          {{rig.excitation.channel, std::move(force)}}, DampingLaw::kHysteretic);
}

std::optional<Warning> stiffness_warning(const StickState& state, const Joint& joint) {
  constexpr double kMostDifference = 0.01;
  const double k = state.stiffness;
  if (k <= 0.0 || std::abs(joint.stiffness() / k - 1.0) <= kMostDifference) return std::nullopt;
  return Warning{
      "stiffness_differs",
      fmt::format("The joint has k = {:.5g} N/m, the contact of the rig {:.5g} N/m, with "
                  "which its modes were computed. Give both the same.",
                  joint.stiffness(), k)};
}

}  // namespace microslip
