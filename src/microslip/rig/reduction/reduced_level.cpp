// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/reduced_level.hpp"

#include <algorithm>

namespace microslip {

bool ReducedLevel::has_flag(std::string_view code) const {
  return std::ranges::any_of(flags, [&](const Warning& flag) { return flag.code == code; });
}

}  // namespace microslip
