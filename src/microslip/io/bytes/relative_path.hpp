// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// How a file that will lie at `from` names another: relative to its folder, unless the other was
/// given from the root, or `from` is standard output.
[[nodiscard]] std::string path_from(const std::string& other, const std::string& from);

}  // namespace microslip
