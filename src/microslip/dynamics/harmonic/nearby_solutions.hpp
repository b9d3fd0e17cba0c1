// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/dynamics/harmonic/balance_run.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance_options.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/harmonic/target.hpp"

/// @file
/// Vibrations with two given quantities, from vibrations near them. Internal to dynamics.

namespace microslip {

/// The quantities of a vibration, and where its search starts.
struct NearbyTargets {
  Target first;
  Target second;
  SteadyVibration start;  ///< with the joints and the harmonics of the equations
};

/// Finds them, in their order. The equations, which of a structure of many modes take longer than
/// their solution, are made once.
/// @throws InputError  where the number of harmonics or joints of a start is another.
[[nodiscard]] std::vector<VibrationResult> nearby_solutions(const JointedStructure& structure,
                                                            const ResponsePoint& response,
                                                            const HarmonicBalanceOptions& options,
                                                            std::span<const NearbyTargets> targets);

/// The vibration at an outcome, with a summary of how it was found, but for the time it took.
[[nodiscard]] VibrationResult solution_of(BalanceRun& run, const BalanceRun::Outcome& outcome,
                                          const Target& first, const Target& second);

}  // namespace microslip
