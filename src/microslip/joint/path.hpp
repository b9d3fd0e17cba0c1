// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace microslip {

/// The rules on a displacement path and the forces that answer it.
/// @throws InputError  where the lengths differ, or naming the first x (0-based) that is not
///                     finite.
void check_path(std::span<const double> x, std::span<const double> force);

/// The same with a normal load: p ≥ 0 and finite, of the length of x.
void check_path(std::span<const double> x, std::span<const double> normal_load,
                std::span<const double> force);

}  // namespace microslip
