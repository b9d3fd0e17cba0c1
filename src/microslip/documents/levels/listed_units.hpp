// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// "Hz", "g/N" and "g" of "Hz, g/N, g", the units of the columns of a matrix. A comma may end the
/// list.
[[nodiscard]] std::vector<std::string> listed_units(std::string_view text);

}  // namespace microslip
