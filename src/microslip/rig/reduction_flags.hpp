// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/rig/record_analysis.hpp"
#include "microslip/rig/reduction.hpp"

/// @file
/// What is to be looked at in a level. Internal to rig.

namespace microslip {

/// Adds the flags that Reducer documents to a level whose values are set. Those of what makes D and
/// k_eq wrong come first; a k_eq that is not positive is taken out.
void add_flags(ReducedLevel& level, const RecordAnalysis& record, const Reducer& reducer);

}  // namespace microslip
