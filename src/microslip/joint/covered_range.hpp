// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "microslip/base/summary.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip {

/// A warning, `beyond_identification`, where a joint moves more than in the levels it was
/// identified from: kA of a cycle of amplitude A exceeds `covered_to` by more than 2 %. Slip beyond
/// that is an assumption. The 2 % admit a level that is predicted a little high.
/// @param joint       as identified.
/// @param amplitude   A, m; ≥ 0.
/// @param covered_to  kA of the highest level, N; nothing where that is not known: no warning.
[[nodiscard]] std::optional<Warning> beyond_identification(const Joint& joint, double amplitude,
                                                           std::optional<double> covered_to);

}  // namespace microslip
