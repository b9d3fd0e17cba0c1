// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// What a flag of a level or of a verification says, for those who read the report. Empty for a
/// code that is not known here.
[[nodiscard]] std::string_view flag_meaning(std::string_view code);

}  // namespace microslip
