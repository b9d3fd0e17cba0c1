// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/core.hpp"

/// @file
/// Levels as rows of a density: D and k_eq are linear in it. Scaled: amplitude a = A/A_max, slip
/// force s = f*/(kA_max), density p = kA_max φ, dissipation d = D/(kA_max²), softening 1 −
/// k_eq/k. The density is continuous and linear between rising knots s, constant below the first
/// and zero above the last. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// d of each amplitude, ∫ 4s(a − s)p ds up to a [AR14 (7)], from p at the knots: amplitudes ×
/// knots.
[[nodiscard]] Eigen::MatrixXd dissipation_rows(const Eigen::VectorXd& amplitude,
                                               const std::vector<double>& knots);

/// 1 − k_eq/k of each amplitude from p at the knots: amplitudes × knots.
[[nodiscard]] Eigen::MatrixXd softening_rows(const Eigen::VectorXd& amplitude,
                                             const std::vector<double>& knots);

/// d of a single slider of weight 1 at s: 4s(a − s) above s, else 0.
[[nodiscard]] Eigen::VectorXd atom_dissipation(const Eigen::VectorXd& amplitude, double s);

/// 1 − k_eq/k of a single slider of weight 1 at s.
[[nodiscard]] Eigen::VectorXd atom_softening(const Eigen::VectorXd& amplitude, double s);

}  // namespace microslip
