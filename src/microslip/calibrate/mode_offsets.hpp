// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/calibrate/calibration_result.hpp"
#include "microslip/calibrate/level_states.hpp"
#include "microslip/calibrate/mode_unknowns.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/observe/modal_levels.hpp"

/// @file
/// Frequencies of the modes without joints, from those of the levels. Internal to calibrate.

namespace microslip {

/// How the frequency of a level is off that of the structure as it was given.
struct LevelOffset {
  std::size_t mode = 0;                      ///< from 0
  double offset = 0.0;                       ///< of ln ω, 1
  std::vector<double> joint_stiffness = {};  ///< secant stiffness of each joint there, N/m
};

/// The levels that were found and have a frequency, of each mode those of its first session.
[[nodiscard]] std::vector<LevelOffset> level_offsets(const ModalLevels& levels,
                                                     const LevelStates& states);

/// Whether a level is of the session of the first level of its mode: other sessions are off that.
[[nodiscard]] bool of_first_session(const ModalLevels& levels, std::size_t level);

/// How the modes without joints are off: with the springs across the joints in them as given, or
/// all that is not a joint alike, as by a modulus that is wrong. Vibrations are then off by the
/// share of their stiffness that is of the modes, or that is not of joints.
enum class ModesOff { kWithSpringsAsGiven, kAllAlike };

/// The offsets of the modes as unknowns, with the mean and the deviation of those that vibrations
/// determine, as found_modes() has them, but kFrequencyResolution at least. None where no vibration
/// determines one. They begin with the nearest to the mean with which the vibrations are as
/// measured, or with the mean where no structure has these.
/// @param structure, levels  as of found_modes().
[[nodiscard]] ModeUnknowns mode_unknowns(const JointedStructure& structure,
                                         const std::vector<LevelOffset>& levels, ModesOff off);

/// The coefficients of the offsets that the states have.
[[nodiscard]] Eigen::VectorXd offset_coefficients(const ModeUnknowns& modes,
                                                  const LevelStates& states);

/// The offsets of the modes without joints with which each measured mode is off as its levels are
/// on the mean, at the mean stiffness of the joints: see modal_offsets(). Modes of which nine
/// tenths of the stiffness are those of joints determine none. Modes that are not determined have
/// the mean of the n offsets that are, with s√(1 + 1/n), s their scatter, or of one or two their
/// rms; those that are what their levels scatter by about their offset, rms. Nothing of no level.
/// @param structure  as it was given, with the joints found.
/// @param levels     that count.
/// @throws InputError  where no modes have these frequencies.
[[nodiscard]] FoundModes found_modes(const JointedStructure& structure,
                                     const std::vector<LevelOffset>& levels);

}  // namespace microslip
