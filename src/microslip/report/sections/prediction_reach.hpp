// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/report_document.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// What predictions from a joint are good for: the motions that were measured, what lies beyond,
/// and their error where they were held against recordings. Internal to report.

namespace microslip {

/// Of a joint that was identified from levels, or whose file does not tell from what.
/// @param results  with a joint.
[[nodiscard]] ReportFacts reach_of_levels(const ExperimentResults& results);

/// Of a joint that was identified from records of force and displacement.
[[nodiscard]] ReportFacts reach_of_records(const ExperimentResults& results);

/// Of joints that were found from levels of modes.
/// @param results  with a calibration.
[[nodiscard]] ReportFacts reach_of_calibration(const ExperimentResults& results);

/// Of tests against a model without a joint beside them.
[[nodiscard]] ReportFacts reach_of_comparison(const ComparisonFound& found);

}  // namespace microslip
