// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/rig/record_analysis.hpp"
#include "microslip/rig/reduction.hpp"

/// @file
/// Internal to rig.

namespace microslip {

/// What an analysed record tells, with its flags: the second half of Reducer::reduce().
[[nodiscard]] ReducedLevel reduced_level(const RecordAnalysis& record, const Reducer& reducer);

}  // namespace microslip
