// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "microslip/structure/meshed_structure.hpp"

namespace microslip::bench {

/// A block of steel from bricks of 8 nodes, all alike, by full integration: fixed at its face x =
/// 0, with a point "tip" along z at its opposite corner. Its mass is consistent.
/// @param bricks  along x, y and z, each ≥ 1.
/// @param edges   of one of them, m.
[[nodiscard]] MeshedStructure brick_block(const std::array<std::size_t, 3>& bricks,
                                          const std::array<double, 3>& edges);

}  // namespace microslip::bench
