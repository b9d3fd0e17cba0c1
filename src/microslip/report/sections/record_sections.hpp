// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/report_document.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The sections of the report of a joint that was identified from records of force and
/// displacement. Internal to report.

namespace microslip {

/// What was found, with the density and what was looked for in the records beside it.
/// @param results  with a joint that was identified from records.
[[nodiscard]] ReportSection record_summary_section(const ExperimentResults& results);

/// Measured and found force over time, and the difference.
[[nodiscard]] ReportSection record_force_section(const ExperimentResults& results);

/// The same over the displacement.
[[nodiscard]] ReportSection record_loops_section(const ExperimentResults& results);

/// D, k_eq and η of the joint over the amplitudes that the records tell.
[[nodiscard]] ReportSection derived_section(const ExperimentResults& results);

/// A table of the records, and where there are several what was looked for in each.
[[nodiscard]] ReportSection records_section(const ExperimentResults& results);

}  // namespace microslip
