// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/calibrate/calibration_options.hpp"
#include "microslip/calibrate/calibration_result.hpp"
#include "microslip/calibrate/growing_range.hpp"

/// @file
/// Results of a calibration from its settled state. Internal to calibrate.

namespace microslip {

/// Draws the posterior, and computes joints, levels and joints known only together from the draws.
/// The states are solved once more with the resulting joints.
void read_calibration(const CalibrationEvidence& evidence, const CalibrationOptions& options,
                      const CalibratedState& state, GrowingRange& range, LevelStates& states,
                      CalibrationResult& result);

}  // namespace microslip
