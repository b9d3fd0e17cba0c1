// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "microslip/dynamics/march/march.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// A mode of the stuck structure, and how far it is drawn aside.
struct DrawnMode {
  std::size_t mode;     ///< by frequency with all joints stuck, from 0
  double displacement;  ///< of its part at the point, m; not 0
};

/// The initial state of a structure released at rest for a free decay: the sum of the shapes of
/// stuck modes (see JointedStructure::stuck_mode), each with its displacement at a point. The
/// joints reach it on the virgin curve.
/// @param structure  the structure.
/// @param point      of the modal model.
/// @param modes      deflected modes.
/// @throws InputError  for a mode that there is not, one named twice, one that does not move the
///                     point, a displacement that is 0 or not finite.
[[nodiscard]] InitialState released(const JointedStructure& structure, std::string_view point,
                                    std::span<const DrawnMode> modes);

}  // namespace microslip
