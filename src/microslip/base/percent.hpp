// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// A fraction as a percentage for messages: one decimal, below 1 % two significant digits, without
/// an exponent above 1 %: "0.57 %", "12.3 %", "140.0 %".
/// @param share  the fraction, 1.
[[nodiscard]] std::string percent_text(double share);

}  // namespace microslip
