// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// What a file is by its first bytes: "a PNG picture", "a MATLAB file", "an HDF5 file", "JSON", …;
/// empty where they are those of no format known here, as with tables.
[[nodiscard]] std::string_view signature(std::string_view head);

}  // namespace microslip
