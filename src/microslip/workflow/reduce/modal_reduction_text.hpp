// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/modal_reduction.hpp"

/// @file
/// What is said of modal levels. Internal to workflow.

namespace microslip {

/// A line a level, and its flags.
[[nodiscard]] std::string describe_modal_reduction(const ModalReducer& reducer,
                                                   const ModalReductionBatch& batch);

/// What the file must say: each kind of flag with its text, and what was left out.
[[nodiscard]] std::vector<Warning> modal_warnings(const ModalReductionBatch& batch);

}  // namespace microslip
