// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// @file
/// Comments at the head of what this program writes, in the languages that it writes.

namespace microslip {

/// What stands behind the sign of a comment: "# ", "** ", "! ", "// " or "/* "; empty where a line
/// begins with none of these.
[[nodiscard]] std::string_view comment_text(std::string_view line);

}  // namespace microslip
