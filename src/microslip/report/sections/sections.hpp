// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "microslip/identify/methods/method_comparison.hpp"
#include "microslip/report/document/report_document.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The sections of the report of a test. Internal to report.

namespace microslip {

[[nodiscard]] ReportSection summary_section(const ExperimentResults& results,
                                            const std::optional<MethodComparison>& methods);
[[nodiscard]] ReportSection levels_section(const ExperimentResults& results);
[[nodiscard]] ReportSection signals_section(const ExperimentResults& results);
[[nodiscard]] ReportSection energies_section(const ExperimentResults& results);
[[nodiscard]] ReportSection density_section(const ExperimentResults& results,
                                            const std::optional<MethodComparison>& methods);
[[nodiscard]] ReportSection loops_section(const ExperimentResults& results,
                                          const std::optional<MethodComparison>& methods);
[[nodiscard]] ReportSection stiffness_section(const ExperimentResults& results);
[[nodiscard]] ReportSection responses_section(const ExperimentResults& results);
[[nodiscard]] ReportSection curves_section(const ExperimentResults& results);
[[nodiscard]] ReportSection predictions_section(const ExperimentResults& results);
[[nodiscard]] ReportSection comparison_section(const ExperimentResults& results);
[[nodiscard]] ReportSection campaign_section(const ExperimentResults& results);
/// Summary of a folder with a comparison alone. @param results  with a comparison.
[[nodiscard]] ReportSection comparison_summary_section(const ExperimentResults& results);
[[nodiscard]] ReportSection rig_section(const ExperimentResults& results);
[[nodiscard]] ReportSection provenance_section(const ExperimentResults& results);

}  // namespace microslip
