// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/density.hpp"

namespace microslip {

/// Φ0, Φ1 and Φ2 at s of a density without its atoms. @param s  N.
[[nodiscard]] PartialMoments continuous_moments(const SlipDensity& density, double s);

}  // namespace microslip
