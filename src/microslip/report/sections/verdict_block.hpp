// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/report/document/report_document.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The verdict at the top of a report. Internal to report.

namespace microslip {

/// The codes of warnings, each once.
[[nodiscard]] std::vector<std::string> codes_of(const std::vector<Warning>& warnings);

/// Whether a joint is reliable: the departures tested and found, and the status of the solver.
/// @param status  as IdentifiedJoint has it.
/// @param looked_for  a departure may stand there several times, once per record.
/// @param warnings  those that the section shows.
[[nodiscard]] ReportVerdict verdict_on_joint(std::span<const DepartureFound> looked_for,
                                             const std::string& status,
                                             const std::vector<Warning>& warnings);

}  // namespace microslip
