// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// A warning, `damping_twice`, for each joint and mode whose loss seems to be given twice: nine
/// tenths or more of the stiffness of the mode are that of the joint, k_s ψ_i² ≥ 0.9 ω_i², so that
/// both lose what the same motion loses, and the loss factor of the mode is, to a factor of 2, that
/// due to the linear damping of the joint alone, βψ_i²/(πω_i²).
[[nodiscard]] std::vector<Warning> damping_twice(const JointedStructure& structure);

}  // namespace microslip
