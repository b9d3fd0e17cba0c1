// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "microslip/rig/verification/verification.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip {

/// Adds predictions and comparisons as the tables hold them, with finer histories of the prediction
/// and the standard errors of the harmonics beside them.
void add_verified(std::span<const Verification> records, ExperimentResults& results);

}  // namespace microslip
