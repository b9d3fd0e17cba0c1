// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <vector>

#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/rig/reduction/cycle_reduction.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"

/// @file
/// A vibration of rig_structure() as the sensors of the rig see it. Internal to rig.

namespace microslip {

/// Factors of e^{inωt}, entry n that of harmonic n.
using Harmonics = std::vector<std::complex<double>>;

/// F_n = A s_n of the force that drives a vibration.
[[nodiscard]] Harmonics force_harmonics(const SteadyVibration& vibration,
                                        const Excitation& excitation);

/// Force, accelerations and, where the layout has it, vibrometer; in the order of RecordSignals.
[[nodiscard]] std::vector<Harmonics> channel_harmonics(const SteadyVibration& vibration,
                                                       Harmonics force, const Rig& rig,
                                                       const StickState& state,
                                                       const SignalLayout& layout);

}  // namespace microslip
