// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/algebra/core.hpp"

namespace microslip {

/// Static displacements q of modes that springs at J places hold:
///
///     (diag(w) + ψ diag(k) ψᵀ) q = p
///
/// in O(mJ² + J³) operations for m modes. Modes that are stiff against the springs are eliminated:
/// at the places they are springs in series, C = (k⁻¹ + ψᵀw⁻¹ψ)⁻¹, which hold the others, rigid
/// bodies above all. Motions that nothing restrains are 0. Internal to dynamics.
/// @param stiffness  w, one per mode, N/(kg m), 0 or more.
/// @param shapes     ψ, modes × places, kg^-½.
/// @param springs    k, one per place, N/m, above 0.
/// @param loads      p, modes × loads.
/// @return q, modes × loads.
[[nodiscard]] Eigen::MatrixXd held_displacements(const Eigen::VectorXd& stiffness,
                                                 const Eigen::MatrixXd& shapes,
                                                 const Eigen::VectorXd& springs,
                                                 const Eigen::MatrixXd& loads);

}  // namespace microslip
