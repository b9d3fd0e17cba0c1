// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/rig/reduction.hpp"
#include "microslip/rig/reduction_batch.hpp"

namespace microslip::app {

/// A reduction as text for a person: how it was done, a line a level, and what is to be looked at.
[[nodiscard]] std::string describe_reduction(const Reducer& reducer, const ReductionBatch& batch);

}  // namespace microslip::app
