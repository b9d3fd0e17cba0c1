// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/dynamics/harmonic/balance_equations.hpp"

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

  /// The sign of the determinant: of the curve, with the tangent as the last row. That of the part
  /// at rest would show where a motion may lose its symmetry, where the curve does not turn back.
  [[nodiscard]] int determinant_sign() const;

  /// Whether there are factors of so many unknowns that they are worth reusing.
  [[nodiscard]] bool are_costly() const { return moving_.size() >= kMany; }

  /// The direction in which neither the balance nor the first row changes at the present point,
  /// near that of these factors: by refinement.
  struct Tangent {
    Eigen::VectorXd direction;  ///< in z, of any length, with b·direction > 0
    /// The sign of the determinant there with a last row v for which v·direction > 0.
    int determinant_sign;
  };
  /// @param first  the row a there, by z itself. @return none where refinement does not converge.
  [[nodiscard]] std::optional<Tangent> tangent(BalanceEquations& equations,
                                               const Eigen::RowVectorXd& first) const;

 private:
  static constexpr std::size_t kMany = 100;

  [[nodiscard]] Eigen::VectorXd product(const Eigen::MatrixXd& jacobian,
                                        const Eigen::RowVectorXd& first,
                                        const Eigen::VectorXd& x) const;

  std::vector<Eigen::Index> moving_;
  Eigen::VectorXd scale_;    // of what moves
  Eigen::RowVectorXd last_;  // b of what moves
  Eigen::MatrixXd matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace microslip
