// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// @file
/// Where the energy of a march goes.

namespace microslip {

/// What became of the energy in one joint, J.
struct JointEnergy {
  std::string joint;  ///< its name in the structure
  /// Σ ∫ f_i d|z_i| of the sliders, by the closed form on each branch (Memory::dissipation).
  double dissipation = 0.0;
  /// Σ ½κ_i(x − z_i)² of the springs at the end (Memory::stored_energy), and ½cF² of what is in
  /// series.
  double stored = 0.0;
  /// Of the damper beside F that stands for the linear damping of the joint, ∫ c u̇² dt by
  /// quadrature.
  double linear_dissipation = 0.0;
};

/// Where the energy went, J, from the first time to the last that was reached:
///
///     initial + input = kinetic + elastic + linear dissipation
///                       + Σ_joints (stored + dissipation + its own linear dissipation)
///
/// Each by itself, never as the rest of the others: the work of the forces ∫ f ẇ dt and Σ η_i ω_i ∫
/// q̇_i² dt by quadrature, with velocities inside of the steps or, where steps are cut, of fourth
/// order over the states at the ends of the pieces; the joints from the displacements at which they
/// turned. So the imbalance measures the error of the integration.
///
/// For a joint whose normal load varies stored and lost energy cannot be told apart from the work
/// of the load; its `dissipation` then holds ∫ F du, `stored` ½cF² alone.
struct MarchEnergy {
  double initial = 0.0;             ///< of the initial state
  double at_rest = 0.0;             ///< what of it the static loads hold, where there are any
  double input = 0.0;               ///< ∫ Σ f ẇ dt
  double linear_dissipation = 0.0;  ///< Σ_i η_i ω_i ∫ q̇_i² dt
  double kinetic = 0.0;             ///< ½ Σ q̇_i², at the end
  double elastic = 0.0;  ///< ½ Σ ω_i² q_i² − ½ Σ_j k_s,j (ψ_j·q)², at the end
  std::vector<JointEnergy> joints;  ///< in the order of the structure

  /// Of all joints.
  [[nodiscard]] double joint_dissipation() const;
  /// Of all joints.
  [[nodiscard]] double joint_stored() const;
  /// Of all joints.
  [[nodiscard]] double joint_linear_dissipation() const;

  /// Less than this of the rest under static loads is no motion, but rounding.
  static constexpr double kLeastOfRest = 1e-6;

  /// |left − right|/max(|left|, |right|) of the balance, without the energy at rest (of which 1e-6
  /// count), 1; 0 where nothing moves.
  [[nodiscard]] double imbalance() const;
};

}  // namespace microslip
