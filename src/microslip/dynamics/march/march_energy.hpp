// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// @file
/// Energy balance of a march.

namespace microslip {

/// Energies of one joint, J.
struct JointEnergy {
  std::string joint;  ///< its name in the structure
  /// Σ ∫ f_i d|z_i| of the sliders, by the closed form on each branch (Memory::dissipation).
  double dissipation = 0.0;
  /// Σ ½κ_i(x − z_i)² of the springs at the end (Memory::stored_energy), and ½cF² of what is in
  /// series.
  double stored = 0.0;
  /// Loss of the damper parallel to F that represents the linear damping of the joint, ∫ c u̇² dt
  /// by quadrature.
  double linear_dissipation = 0.0;
};

/// Energy balance, J, from the first time to the last that was reached:
///
///     initial + input = kinetic + elastic + linear dissipation
///                       + Σ_joints (stored + dissipation + its own linear dissipation)
///
/// Each computed by itself, none as the remainder of the others: the work of the forces ∫ f ẇ dt
/// and Σ η_i ω_i ∫ q̇_i² dt by quadrature, with velocities inside of the steps or, where steps are
/// cut, of fourth order over the states at the ends of the pieces; the joints from the
/// displacements at which they turned. So the imbalance measures the error of the integration.
///
/// For a joint whose normal load varies stored and lost energy cannot be distinguished from the
/// work of the load; its `dissipation` is then ∫ F du, `stored` ½cF² alone.
struct MarchEnergy {
  double initial = 0.0;             ///< of the initial state
  double at_rest = 0.0;             ///< the part of it at rest under static loads, if any
  double input = 0.0;               ///< ∫ Σ f ẇ dt
  double linear_dissipation = 0.0;  ///< Σ_i η_i ω_i ∫ q̇_i² dt
  double kinetic = 0.0;             ///< ½ Σ q̇_i², at the end
  double elastic = 0.0;  ///< ½ Σ ω_i² q_i² − ½ Σ_j k_s,j (ψ_j·q)², at the end
  std::vector<JointEnergy> joints;  ///< in the order of the structure

  /// Sum over all joints.
  [[nodiscard]] double joint_dissipation() const;
  /// Sum over all joints.
  [[nodiscard]] double joint_stored() const;
  /// Sum over all joints.
  [[nodiscard]] double joint_linear_dissipation() const;

  /// A motion below this share of the static displacement is rounding.
  static constexpr double kLeastOfRest = 1e-6;

  /// |left − right|/max(|left|, |right|) of the balance, without the energy at rest (of which 1e-6
  /// count), 1; 0 where nothing moves.
  [[nodiscard]] double imbalance() const;
};

}  // namespace microslip
