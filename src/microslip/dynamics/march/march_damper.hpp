// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// ω of the lowest mode of the stuck structure in which a joint moves, rad/s; 0 where there is
/// none. Rigid bodies do not count. Internal to dynamics.
[[nodiscard]] double frequency_of_joint(const JointedStructure& structure, std::size_t joint);

/// c = β/(πω), N s/m: the viscous damper that loses βA² a cycle, as the linear damping of the joint
/// does, at the frequency above. 0 without linear damping. Internal to dynamics.
[[nodiscard]] double damper_of_joint(const JointedStructure& structure, std::size_t joint);

}  // namespace microslip
