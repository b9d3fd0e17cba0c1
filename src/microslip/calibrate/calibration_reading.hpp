// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/calibrate/calibration_options.hpp"
#include "microslip/calibrate/calibration_result.hpp"
#include "microslip/calibrate/growing_range.hpp"

/// @file
/// From what was settled to what is told of it. Internal to calibrate.

namespace microslip {

/// Draws the posterior, and reads joints, levels and what cannot be told apart from the draws. The
/// states are solved once more with the joints that come of it.
void read_calibration(const CalibrationEvidence& evidence, const CalibrationOptions& options,
                      const CalibratedState& state, GrowingRange& range, LevelStates& states,
                      CalibrationResult& result);

}  // namespace microslip
