// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip::bench {

/// Many modes and many joints: a rod of 1 kg that is clamped at one end and rubs along its length.
///
///     φ_i(x) = √2 sin((i − ½)πx),   ω_i = (2i − 1)ω_1,   ω_1 = 2π·20 rad/s, η_i = 0.01
///
/// The joints, from the ground to places spread over the rod, hold together as much as the first
/// mode does, and slip together at 100 N. Driven at the point "tip".
[[nodiscard]] JointedStructure friction_rod(std::size_t modes, std::size_t joints);

}  // namespace microslip::bench
