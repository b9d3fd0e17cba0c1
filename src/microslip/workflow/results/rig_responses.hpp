// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Predictions of a joint for the rig, for the report.

namespace microslip {

/// Adds the backbone over the responses of the levels and frequency responses at some of them, by
/// the joint of the results and, where there is one, by the true joint. A curve that does not
/// converge is left out, and nothing is added where rig, joint or the response amplitudes of levels
/// are missing.
void add_predictions(ExperimentResults& results);

}  // namespace microslip
