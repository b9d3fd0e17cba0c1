// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// Meaning of a flag of a level or of a verification, for the report. Empty for a
/// code that is not known here.
[[nodiscard]] std::string_view flag_meaning(std::string_view code);

}  // namespace microslip
