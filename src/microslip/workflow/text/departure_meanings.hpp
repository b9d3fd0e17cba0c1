// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

/// A departure from a Masing joint in words, by its code; the code itself of one that is not known
/// here.
[[nodiscard]] std::string departure_meaning(std::string_view code);

/// The same with the code in brackets behind, for scripts: "play, pinching or bearing (dead_zone)".
[[nodiscard]] std::string departure_with_code(std::string_view code);

}  // namespace microslip
