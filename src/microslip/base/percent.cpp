// SPDX-License-Identifier: MIT
#include "microslip/base/percent.hpp"

#include <fmt/format.h>

#include <cmath>

namespace microslip {

std::string percent_text(double share) {
  const double value = 100.0 * share;
  return std::abs(value) < 1.0 ? fmt::format("{:#.2g} %", value) : fmt::format("{:.1f} %", value);
}

}  // namespace microslip
