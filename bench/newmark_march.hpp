// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip::bench {

/// Reference of march(): Newmark's scheme with average acceleration on the modes of a structure
/// with one joint without shortening, in equal steps from rest. The joint force of a step is found
/// by Newton's method on its Memory; reversals are at the ends of steps.
/// @param force  at the first excitation, one per time. @return the displacement there.
[[nodiscard]] std::vector<double> newmark_march(const JointedStructure& structure,
                                                const std::vector<double>& force, double step,
                                                double tolerance);

}  // namespace microslip::bench
