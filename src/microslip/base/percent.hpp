// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// A share in percent for a person to read: one digit behind the point, below 1 % two digits, and
/// no exponent from there on up: "0.57 %", "12.3 %", "140.0 %".
/// @param share  of 1.
[[nodiscard]] std::string percent_text(double share);

}  // namespace microslip
