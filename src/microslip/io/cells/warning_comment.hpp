// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "microslip/base/summary.hpp"

namespace microslip {

/// "warning: CODE: TEXT" on one line, as comments of tables and of TOML have it.
[[nodiscard]] std::string warning_comment(const Warning& warning);

/// Reads such a comment, without its mark and blanks, back; nothing where it is another.
[[nodiscard]] std::optional<Warning> parse_warning_comment(std::string_view comment);

}  // namespace microslip
