// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/modal_level.hpp"

#include <algorithm>

namespace microslip {

bool ModalLevel::has_flag(std::string_view code) const {
  return std::ranges::find(flags, code, &Warning::code) != flags.end();
}

}  // namespace microslip
