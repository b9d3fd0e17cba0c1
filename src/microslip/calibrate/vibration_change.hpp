// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/calibrate/level_states.hpp"
#include "microslip/calibrate/linearisation.hpp"

/// @file
/// Changes of the vibrations of the levels from pass to pass. Internal to calibrate.

namespace microslip {

/// The vibration of a level; zeros where it was not found.
struct LevelVibration {
  double angular_frequency = 0.0;  ///< rad/s
  std::vector<double> amplitude;   ///< of each joint that is sought, m
};

/// The vibrations of all levels.
/// @param sought  joints of the structure.
[[nodiscard]] std::vector<LevelVibration> vibrations_of(const LevelStates& states,
                                                        std::size_t levels,
                                                        const std::vector<std::size_t>& sought);

/// Largest relative change of frequencies and amplitudes; 1 of those that were not found.
[[nodiscard]] double largest_change(const std::vector<LevelVibration>& before,
                                    const std::vector<LevelVibration>& after);

/// Largest change of what a row shows, over the standard deviation that it counts with: of a
/// frequency ω, of the amplitude of a joint, and of a loss Σ_j |dD_j/da_j Δa_j|. 1 and more of a
/// level that was found in one of them only.
/// @param linear   rows of the levels.
/// @param weights  scatter of each kind of rows.
/// @param states   with the joints.
[[nodiscard]] double change_over_deviations(const std::vector<LevelVibration>& before,
                                            const std::vector<LevelVibration>& after,
                                            const LinearisedLevels& linear,
                                            const EvidenceWeights& weights,
                                            const LevelStates& states,
                                            const std::vector<std::size_t>& sought);

}  // namespace microslip
