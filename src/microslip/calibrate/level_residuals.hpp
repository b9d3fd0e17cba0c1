// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/calibrate/calibration_result.hpp"
#include "microslip/calibrate/linearisation.hpp"

/// @file
/// Levels as measured against those of the joints found. Internal to calibrate.

namespace microslip {

/// Mean frequency offsets of each mode, and of the mode and session of each level.
/// @param result  whose levels are there; gets their `frequency_offset` and its own.
void read_offsets(const CalibrationEvidence& evidence, const LevelStates& states,
                  CalibrationResult& result);

/// Residuals of the levels over their standard deviations, the noise of their losses, and bands of
/// losses that extend to 0 where the error of a level does.
/// @param losses  [level][joint][draw], J.
/// @param result  whose levels have their losses and offsets.
void read_deviations(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                     const LevelStates& states,
                     const std::vector<std::vector<std::vector<double>>>& losses,
                     CalibrationResult& result);

}  // namespace microslip
