// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/report/document/report_document.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip {

/// The report: summary, levels, signals, energies, density, loops, stiffness, responses,
/// predictions, rig, provenance. Densities by the other methods, the path of the smoothing
/// parameter and loops for several smoothing factors are computed from the levels. A part without
/// data is named in a list of what is not there, with the command that makes it; levels that the
/// methods refuse are shown without them, and the summary says so.
/// @throws InputError  where vectors that belong together differ in length.
[[nodiscard]] ReportDocument experiment_report(ExperimentResults results);

}  // namespace microslip
