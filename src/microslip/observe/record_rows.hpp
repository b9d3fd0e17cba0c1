// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/observe/path_rows.hpp"

/// @file
/// A path as rows of a density: the force is linear in it. Scaled by a length X and a stiffness
/// k₀: half range h/X, slip displacement s = x*/X, density p = Xψ/k₀, force F/(k₀X). The
/// density is continuous and linear between rising knots s, constant below the first and zero above
/// the last. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// ∫ min(h, s) p ds from p at the knots. @param h  half range, ≥ 0.
[[nodiscard]] Eigen::RowVectorXd virgin_row(double h, const std::vector<double>& knots);

/// The force of each row without offset and elastic remainder, from p at the knots: rows × knots.
/// @param path    of the record.
/// @param length  X, m.
/// @param knots   s.
[[nodiscard]] Eigen::MatrixXd stop_rows(const PathRows& path, double length,
                                        const std::vector<double>& knots);

}  // namespace microslip
