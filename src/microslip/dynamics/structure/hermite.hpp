// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "microslip/algebra/core.hpp"

namespace microslip {

/// A point of a curve over t, and its derivative by t. Internal to dynamics.
struct HermiteKnot {
  double t;
  Eigen::VectorXd value;
  Eigen::VectorXd slope;
};

/// The polynomial of degree 2m − 1 through m knots with their slopes (Hermite's), at t:
///
///     Σ_i L_i² {[1 − 2 L_i′(t_i)(t − t_i)] value_i + (t − t_i) slope_i},
///     L_i = Π_j≠i (t − t_j)/(t_i − t_j)
///
/// @param knots  at least one, no two at the same t.
[[nodiscard]] Eigen::VectorXd hermite_value(std::span<const HermiteKnot> knots, double t);

}  // namespace microslip
