// SPDX-License-Identifier: MIT

#include "microslip/algebra/core.hpp"
#pragma once

namespace microslip {

/// Broyden's method for r(x) = 0 of complex vectors, x and r scaled so that dr/dx is about 1: each
/// pair of points corrects an estimate of the inverse derivative,
///
///     J⁻¹ ← J⁻¹ + (Δx − J⁻¹Δr)(Δxᵀ J⁻¹)/(Δxᵀ J⁻¹ Δr)       [Broyden, Math. Comp. 19 (1965) 577]
///
/// over real and imaginary parts, as r need not be analytic. Internal to rig.
class Broyden {
 public:
  explicit Broyden(Eigen::Index size);

  /// The next x, after r has been found at x.
  [[nodiscard]] Eigen::VectorXcd next(const Eigen::VectorXcd& x, const Eigen::VectorXcd& r);

  /// r becomes another function with about the same derivative.
  void begin_again() { x_.resize(0); }

 private:
  Eigen::MatrixXd inverse_;
  Eigen::VectorXd x_;  // of the last call; empty before it
  Eigen::VectorXd r_;
};

}  // namespace microslip
