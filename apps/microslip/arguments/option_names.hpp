// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip::app {

/// The library names what its caller may choose in back quotes, as a field of its options and a
/// value behind it: "`assume_units force=N`". Here that is "--assume-units force=N", which can be
/// pasted.
[[nodiscard]] std::string with_option_names(std::string_view text);

}  // namespace microslip::app
