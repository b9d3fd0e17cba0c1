// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/harmonic/target.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

/// @file
/// Sensitivity of the resonance of a level to its joints. Internal to calibrate.

namespace microslip {

/// Derivatives of a resonance at a given displacement of the response point. Joint l changes by
/// δκ_l, N/m: its first harmonic is F_1 = κ(a) u_1 with κ = k_eq + iD/(πa²).
struct LevelSensitivity {
  Eigen::RowVectorXcd frequency;  ///< ∂ω/∂Re κ_l − i ∂ω/∂Im κ_l: δω = Re(frequency · δκ)
  Eigen::MatrixXcd amplitude;             ///< the same for a_j, joints × joints
  double frequency_by_response = 0.0;     ///< ∂ω/∂X, X the displacement of the response point
  Eigen::VectorXd amplitude_by_response;  ///< ∂a_j/∂X
  /// ∂ω/∂ln ω_i of each mode without joints, and 2∂ω/∂ln k_s of the spring of each joint in them.
  Eigen::RowVectorXd frequency_by_mode;
  Eigen::MatrixXd amplitude_by_mode;  ///< the same for a_j, joints × (modes, joints)
};

/// The derivatives, with the change of κ itself with the amplitudes. Higher harmonics are assumed
/// to follow, which is accurate to some thousandths, and shortening is neglected.
/// @param structure  with the joints that the vibration is of.
/// @param response   the point whose displacement is kept.
/// @param vibration  a resonance of it, in motion.
/// @param forcing    the excitation that maintains it.
[[nodiscard]] LevelSensitivity level_sensitivity(const JointedStructure& structure,
                                                 std::string_view response,
                                                 const SteadyVibration& vibration, Forcing forcing);

}  // namespace microslip
