// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"

/// @file
/// Codes of warnings as a cell of a table has them: with blanks between. Internal.

namespace microslip {

/// Adds a code unless it is there.
/// @param code  a word, or several as joined_codes() returns them; of none there is nothing to add.
void add_code(std::string& codes, std::string_view code);

/// The codes of the warnings, each once, in their order.
[[nodiscard]] std::string joined_codes(const std::vector<Warning>& warnings);

}  // namespace microslip
