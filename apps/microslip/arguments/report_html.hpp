// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arguments/command.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip::app {

/// The report of a test as an HTML file, with version and call in its provenance.
/// @param pictures  with those for paper. Without gnuplot there are none, and the report says so.
[[nodiscard]] std::string report_html(ExperimentResults results, const Call& call,
                                      bool pictures = true);

}  // namespace microslip::app
