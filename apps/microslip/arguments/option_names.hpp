// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace microslip::app {

/// The library names what its caller may choose in back quotes, as a field of its options and a
/// value behind it: "`assume_units force=N`". Here that is "--assume-units force=N", which can be
/// pasted.
[[nodiscard]] std::string with_option_names(std::string_view text);

/// The same where the command may lack an option that the library names. `spell` has the name in
/// the library and with its hyphens, and returns what stands for it, "--rate of convert".
using SpellOption = std::function<std::string(std::string_view name, const std::string& option)>;
[[nodiscard]] std::string with_option_names(std::string_view text, const SpellOption& spell);

}  // namespace microslip::app
