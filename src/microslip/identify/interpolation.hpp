// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace microslip {

/// φ at a slip force f, linear between knots and constant beyond them. Internal to the library.
/// @param knots   rising, one at least.
/// @param values  one a knot.
[[nodiscard]] double interpolate(const std::vector<double>& knots,
                                 const std::vector<double>& values, double f);

}  // namespace microslip
