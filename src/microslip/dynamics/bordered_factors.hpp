// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "microslip/dynamics/balance_equations.hpp"

namespace microslip {

/// The derivatives of the balance with two more rows below, in relative unknowns, as LU factors
///
///     M = (S⁻¹ J S; a; b),   S = diag(scale)
///
/// of the unknowns that move: the others stay, whatever those do (BalanceEquations::moving).
/// Internal to dynamics.
class BorderedFactors {
 public:
  /// At the z of the equations. @param first, last  the rows a and b, n + 2 each.
  void compute(BalanceEquations& equations, const Eigen::VectorXd& scale,
               const Eigen::RowVectorXd& first, const Eigen::RowVectorXd& last);

  /// M⁻¹ right, n + 2 each; 0 for what does not move.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// The sign of the determinant: of the curve, with the tangent as the last row. That of what does
  /// not move would tell where a motion may lose its symmetry, which does not turn the curve round.
  [[nodiscard]] int determinant_sign() const;

 private:
  std::vector<Eigen::Index> moving_;
  Eigen::MatrixXd matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace microslip
