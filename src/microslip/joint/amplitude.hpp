// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "microslip/base/error.hpp"

namespace microslip {

/// The rule on an amplitude of motion. @throws InputError  unless it is finite and ≥ 0.
inline void check_amplitude(double amplitude) {
  if (!(std::isfinite(amplitude) && amplitude >= 0.0)) {
    throw InputError("amplitude", amplitude, "must be 0 m or more, and finite");
  }
}

}  // namespace microslip
