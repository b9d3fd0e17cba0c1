// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arguments/command.hpp"
#include "microslip/documents/study/about_file.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip::app {

/// The report of a test as an HTML file, with version and call in its provenance.
/// @param pictures  with those for paper. Without gnuplot there are none, and the report says so.
/// @param about     what stands at its head; the title is that of the results.
[[nodiscard]] std::string report_html(ExperimentResults results, const Call& call,
                                      bool pictures = true, const ReportAbout& about = {});

}  // namespace microslip::app
