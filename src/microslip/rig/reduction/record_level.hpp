// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/rig/reduction/record_analysis.hpp"
#include "microslip/rig/reduction/reduced_level.hpp"
#include "microslip/rig/reduction/reduction_options.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"

/// @file
/// Internal to rig.

namespace microslip {

/// Level of an analysed record, with its flags: the second half of Reducer::reduce().
[[nodiscard]] ReducedLevel reduced_level(const RecordAnalysis& record, const Rig& rig,
                                         const StickState& state, const ReductionOptions& options);

}  // namespace microslip
