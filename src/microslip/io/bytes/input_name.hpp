// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// How messages call a file: its path, or "standard input" for "-".
[[nodiscard]] std::string input_name(const std::string& path);

}  // namespace microslip
