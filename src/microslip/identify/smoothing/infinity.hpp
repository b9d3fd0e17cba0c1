// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

/// @file
/// The value of a parameter without limit, and the score of a fit without degrees of freedom.
/// Internal to identify.

namespace microslip {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace microslip
