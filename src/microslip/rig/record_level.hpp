// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/rig/record_analysis.hpp"
#include "microslip/rig/reduced_level.hpp"
#include "microslip/rig/reduction_options.hpp"
#include "microslip/rig/rig.hpp"
#include "microslip/rig/stick_state.hpp"

/// @file
/// Internal to rig.

namespace microslip {

/// What an analysed record tells, with its flags: the second half of Reducer::reduce().
[[nodiscard]] ReducedLevel reduced_level(const RecordAnalysis& record, const Rig& rig,
                                         const StickState& state, const ReductionOptions& options);

}  // namespace microslip
