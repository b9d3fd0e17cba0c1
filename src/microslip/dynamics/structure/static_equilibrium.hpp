// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Equilibrium of a structure under its static loads.
struct StaticEquilibrium {
  std::vector<double> modal;               ///< q_i, kg^½ m; one per mode
  std::vector<double> joint_displacement;  ///< u_j, m; one per joint
  std::vector<double> joint_force;         ///< F_j, N; the same
  int iterations = 0;                      ///< of Newton's method
};

/// The equilibrium under the static loads of a structure whose joints were virgin before:
///
///     ω_i² q_i − Σ_j k_s,j ψ_ij ψ_j·q + Σ_j (ψ_ij − Σ_r Γ_ir q_r) F_j(u_j) = p_i
///
/// with F the virgin curve, p_i of JointedStructure::static_modal_load(), by Newton's method with
/// steps that are halved until the residual falls. Each joint is taken to move monotonically, as it
/// does where the loads grow together and joints transfer little of them to each other.
/// @param structure     with its static loads.
/// @param normal_loads  p of each joint, pF(u) its force; empty: 1.
/// @throws InputError  where there is no equilibrium: a load that nothing or not enough friction
///                     resists.
[[nodiscard]] StaticEquilibrium static_equilibrium(const JointedStructure& structure,
                                                   std::span<const double> normal_loads = {});

}  // namespace microslip
