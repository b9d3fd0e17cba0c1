// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/report_document.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Valid range of predictions from a joint: the motions that were measured, what lies beyond,
/// and their error where they were compared with recordings. Internal to report.

namespace microslip {

/// Valid range of a joint that was identified from levels, or whose file does not give its data.
/// @param results  with a joint.
[[nodiscard]] ReportFacts reach_of_levels(const ExperimentResults& results);

/// Valid range of a joint that was identified from records of force and displacement.
[[nodiscard]] ReportFacts reach_of_records(const ExperimentResults& results);

/// Valid range of joints that were identified from levels of modes.
/// @param results  with a calibration.
[[nodiscard]] ReportFacts reach_of_calibration(const ExperimentResults& results);

/// Verdict on tests against a model without a joint beside them.
[[nodiscard]] ReportFacts reach_of_comparison(const ComparisonFound& found);

}  // namespace microslip
