// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace microslip {

/// The motion of the displacement x of a joint over a cycle.
struct CycleMotion {
  double lowest;          ///< min x, m
  double highest;         ///< max x, m
  std::size_t reversals;  ///< in a cycle; 2 without inner loops, 0 at rest
};

/// A reversal of the displacement x of a joint in a period.
struct CycleTurn {
  double angle;         ///< τ in the period, rad
  double displacement;  ///< x there, m
};

}  // namespace microslip
