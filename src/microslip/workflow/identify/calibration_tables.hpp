// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/calibrate/calibration.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// What calibrate() found as tables, and as what a joint.json says of its identification. Internal
/// to workflow.

namespace microslip {

/// calibration.csv: measured and found of each level that the structure has.
[[nodiscard]] CsvWriter calibration_table(const CalibrationResult& found, const ModalLevels& levels,
                                          const std::vector<std::string>& joints);

/// identifiability.csv: of each joint that was found, over slip force, density with band, and what
/// the levels told of it.
[[nodiscard]] CsvWriter identifiability_table(const CalibrationResult& found);

/// What calibration.json says: of all levels, modes, joints and pairs of joints.
[[nodiscard]] NamedValues record_of_calibration(const CalibrationResult& found);

/// The identification of one joint.
[[nodiscard]] NamedValues record_of_calibration(const CalibrationResult& found,
                                                const CalibratedJoint& joint);

}  // namespace microslip
