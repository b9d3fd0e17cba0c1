// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"

namespace microslip {

/// A reduction as text for a person: how it was done, a line a level, and what is to be looked at.
[[nodiscard]] std::string describe_reduction(const Reducer& reducer, const ReductionBatch& batch);

/// What of it is to be looked at, for the file: each kind of flag once, what is not written or left
/// out.
[[nodiscard]] std::vector<Warning> reduction_warnings(const ReductionBatch& batch);

}  // namespace microslip
