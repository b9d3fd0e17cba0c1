// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace microslip {

/// What a file is by its first bytes: "a PNG picture", "a MATLAB file", "an HDF5 file", "JSON", …;
/// empty where they are those of no format known here, as with tables.
[[nodiscard]] std::string_view signature(std::string_view head);

/// What to do about a file of this signature in place of a text.
[[nodiscard]] std::string_view remedy_for_signature(std::string_view signature);

}  // namespace microslip
