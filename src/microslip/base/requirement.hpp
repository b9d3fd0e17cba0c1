// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {

/// Checks a rule that an argument must keep. Internal to the library.
/// @param what, value, rule, remedy  of the message, see InputError.
/// @throws InputError  where the rule does not hold.
inline void require(bool holds, std::string_view what, double value, std::string_view rule,
                    std::string_view remedy = {}) {
  if (!holds) throw InputError(what, value, rule, remedy);
}

}  // namespace microslip
