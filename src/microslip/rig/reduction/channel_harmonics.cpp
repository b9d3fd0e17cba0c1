// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/channel_harmonics.hpp"

#include <cstddef>
#include <utility>

#include "microslip/rig/setup/rig_structure.hpp"

namespace microslip {
namespace {

/// u, or what is left of it without the rotation Σ ψ_i q_i of the beam. [AR14 (13)]
Harmonics vibrometer_harmonics(const SteadyVibration& vibration, const StickState& state,
                               RigVibrometer::Measures measures) {
  Harmonics displacement = vibration.joints.front().displacement;
  if (measures == RigVibrometer::Measures::kJoint) return displacement;
  for (std::size_t i = 0; i < state.modes(); ++i) {
    for (std::size_t n = 0; n < displacement.size(); ++n) {
      displacement[n] -= state.joint[i] * vibration.modal[i][n];
    }
  }
  return displacement;
}

}  // namespace

Harmonics force_harmonics(const SteadyVibration& vibration, const Excitation& excitation) {
  Harmonics force(vibration.joints.front().displacement.size());
  for (std::size_t n = 1; n <= excitation.harmonics.size(); ++n) {
    force[n] = vibration.force_amplitude * excitation.harmonics[n - 1];
  }
  return force;
}

std::vector<Harmonics> channel_harmonics(const SteadyVibration& vibration, Harmonics force,
                                         const Rig& rig, const StickState& state,
                                         const SignalLayout& layout) {
  const ModalModel model = rig_modes(rig, state);
  std::vector<Harmonics> channels{std::move(force)};
  for (const RigSensor& sensor : rig.accelerometers) {
    channels.push_back(vibration.acceleration(model, sensor.channel));
  }
  if (layout.vibrometer) {
    channels.push_back(vibrometer_harmonics(vibration, state, *layout.vibrometer));
  }
  return channels;
}

}  // namespace microslip
