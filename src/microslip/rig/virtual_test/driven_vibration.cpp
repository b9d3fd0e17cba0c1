// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/driven_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

double force_distortion(const DrivenVibration& driven, std::size_t harmonics) {
  double largest = 0.0;
  for (std::size_t n = 2; n < driven.force.size() && n <= harmonics; ++n) {
    largest = std::max(largest, std::abs(driven.force[n]));
  }
  return driven.force.size() > 1 ? largest / std::abs(driven.force[1]) : 0.0;
}

}  // namespace microslip
