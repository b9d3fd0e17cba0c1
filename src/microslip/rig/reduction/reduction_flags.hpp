// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/rig/reduction/record_analysis.hpp"
#include "microslip/rig/reduction/reduced_level.hpp"
#include "microslip/rig/reduction/reduction_options.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"

/// @file
/// Flags of a level. Internal to rig.

namespace microslip {

/// Adds the flags that Reducer documents to a level whose values are set. Those of wrong D and k_eq
/// come first; a k_eq that is not positive is removed.
void add_flags(ReducedLevel& level, const RecordAnalysis& record, const Rig& rig,
               const StickState& state, const ReductionOptions& options);

}  // namespace microslip
