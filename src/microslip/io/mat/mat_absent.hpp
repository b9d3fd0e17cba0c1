// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// In a build without files of MATLAB. @throws FileError  which says so, always.
[[noreturn]] void refuse_matlab(const std::string& path);

}  // namespace microslip
