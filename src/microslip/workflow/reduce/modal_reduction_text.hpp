// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/modal_reduction.hpp"

/// @file
/// Texts on modal levels. Internal to workflow.

namespace microslip {

/// One line per level, and its flags.
[[nodiscard]] std::string describe_modal_reduction(const ModalReducer& reducer,
                                                   const ModalReductionBatch& batch);

/// Warnings for the file: each kind of flag with its text, and what was left out.
[[nodiscard]] std::vector<Warning> modal_warnings(const ModalReductionBatch& batch);

}  // namespace microslip
