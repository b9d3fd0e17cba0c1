// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

/// @file
/// Curves over the frequency that are straight in logarithms of both between their points, as
/// specifications give them. Internal to signal.

namespace microslip {

/// @param what    the curve, for messages: "a power density". @param of  its values: "density".
/// @param frequency  Hz. @param value  one per frequency.
/// @throws InputError  naming the value that breaks a rule: two points at least; frequencies above
///                     0 and rising; values above 0, to 1e30.
void check_log_log_line(std::string_view what, std::string_view of,
                        std::span<const double> frequency, std::span<const double> value);

/// The value at a frequency; 0 outside of the points, which must keep the rules above.
[[nodiscard]] double log_log_value(std::span<const double> frequency, std::span<const double> value,
                                   double f);

}  // namespace microslip
