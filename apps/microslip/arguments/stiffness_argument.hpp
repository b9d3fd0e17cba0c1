// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace microslip::app {

/// --stiffness, k of the stuck joint, N/m.
/// @throws InputError  where it is missing, or no stiffness that a joint has.
[[nodiscard]] double parse_stiffness(const std::optional<std::string>& text);

}  // namespace microslip::app
