// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace microslip {

/// A posterior draw of the joint.
struct StiffnessDraw {
  std::vector<double> density = {};  ///< ψ at the knots, N/m per m; ≥ 0
  double stiffness = 0.0;            ///< k = K_e + ∫ψ dx*, N/m
  double viscous = 0.0;              ///< c, N s/m
};

}  // namespace microslip
