// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/summary.hpp"

namespace microslip {

/// "warning: CODE: TEXT" on one line, as comments of tables and of TOML have it.
[[nodiscard]] std::string warning_comment(const Warning& warning);

}  // namespace microslip
