// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/rig/setup/rig.hpp"

namespace microslip {

/// The text that parse_rig() reads back as the same rig.
/// @throws InputError  as check_rig().
[[nodiscard]] std::string format_rig(const Rig& rig);

}  // namespace microslip
