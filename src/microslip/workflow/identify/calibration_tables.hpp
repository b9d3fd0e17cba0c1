// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/calibrate/calibration.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// Results of calibrate() as tables, and as the identification of a joint.json. Internal
/// to workflow.

namespace microslip {

/// calibration.csv: measured and found of each level that the structure has.
[[nodiscard]] CsvWriter calibration_table(const CalibrationResult& found, const ModalLevels& levels,
                                          const std::vector<std::string>& joints);

/// identifiability.csv: of each joint that was found, over slip force, density with band, and
/// its variance reduction.
[[nodiscard]] CsvWriter identifiability_table(const CalibrationResult& found);

/// Record for calibration.json: all levels, modes, joints and pairs of joints.
[[nodiscard]] NamedValues record_of_calibration(const CalibrationResult& found);

/// The identification of one joint.
[[nodiscard]] NamedValues record_of_calibration(const CalibrationResult& found,
                                                const CalibratedJoint& joint);

}  // namespace microslip
