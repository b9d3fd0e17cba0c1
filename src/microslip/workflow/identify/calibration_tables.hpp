// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/calibrate/calibration.hpp"
#include "microslip/io/cells/csv_writer.hpp"

/// @file
/// Results of calibrate() as tables. Internal to workflow.

namespace microslip {

/// calibration.csv: measured and found of each level that the structure has.
[[nodiscard]] CsvWriter calibration_table(const CalibrationResult& found, const ModalLevels& levels,
                                          const std::vector<std::string>& joints);

/// identifiability.csv: of each joint that was found, over slip force, density with band, and
/// its variance reduction.
[[nodiscard]] CsvWriter identifiability_table(const CalibrationResult& found);

}  // namespace microslip
