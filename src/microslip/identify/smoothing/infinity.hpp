// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

/// @file
/// No limit of a parameter, or the score of a fit that leaves nothing to judge it by. Internal to
/// identify.

namespace microslip {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace microslip
