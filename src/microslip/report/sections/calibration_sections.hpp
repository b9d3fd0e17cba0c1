// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/report_document.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The sections of the report of joints that were found from levels of modes. Internal to report.

namespace microslip {

/// Whether the results have any part of a calibration.
[[nodiscard]] bool has_calibration(const ExperimentResults& results);

/// Results, warnings, and the densities of all joints.
[[nodiscard]] ReportSection calibration_summary_section(const ExperimentResults& results);

/// Losses, damping ratios and frequencies, measured and found, their residuals, and the modes.
[[nodiscard]] ReportSection modes_section(const ExperimentResults& results);

/// Displacement and loss of each joint at the levels.
[[nodiscard]] ReportSection joints_at_levels_section(const ExperimentResults& results);

/// Variance reduction of each joint by the levels, and the joints that they do not distinguish.
[[nodiscard]] ReportSection identifiability_section(const ExperimentResults& results);

}  // namespace microslip
