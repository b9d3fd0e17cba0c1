// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "microslip/structure/modal_model.hpp"

namespace microslip {

/// Σ φ_i²/ω_i² over the elastic modes, m/N: their static compliance at a place, the
/// displacement there under a constant unit force.
/// @param modes  any. @param shape  φ at the place, one per mode.
[[nodiscard]] inline double static_compliance(std::span<const Mode> modes,
                                              std::span<const double> shape) {
  double sum = 0.0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double omega = modes[i].angular_frequency;
    if (omega > 0.0) sum += shape[i] * shape[i] / (omega * omega);
  }
  return sum;
}

}  // namespace microslip
