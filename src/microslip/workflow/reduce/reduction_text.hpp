// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"

namespace microslip {

/// Summary of a reduction: how it was done, one line per level, and warnings.
[[nodiscard]] std::string describe_reduction(const Reducer& reducer, const ReductionBatch& batch);

/// Warnings for the file: each kind of flag once, levels not written or left
/// out.
[[nodiscard]] std::vector<Warning> reduction_warnings(const ReductionBatch& batch);

}  // namespace microslip
