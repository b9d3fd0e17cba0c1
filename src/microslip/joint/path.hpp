// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <string_view>

namespace microslip {

/// |x| up to which a joint is followed, m: beyond it differences and energies of a path overflow.
inline constexpr double kFarthestDisplacement = 1e100;

/// Whether a joint can be followed to x [m]: not to NaN.
[[nodiscard]] inline bool can_be_followed(double x) { return std::abs(x) <= kFarthestDisplacement; }

/// @throws InputError  naming x, which cannot be followed, as `name`.
[[noreturn]] void refuse_displacement(std::string_view name, double x);

/// Checks a displacement path and the length of the forces that answer it.
/// @throws InputError  where the lengths differ, or naming the first x (0-based) to which a joint
///                     cannot be followed.
void check_path(std::span<const double> x, std::span<const double> force);

/// Checks a normal load as well: p ≥ 0 and finite, of the length of x.
void check_path(std::span<const double> x, std::span<const double> normal_load,
                std::span<const double> force);

}  // namespace microslip
