// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/summary.hpp"

/// @file
/// The convex quadratic program of the inversion. Internal: the installed headers do not include
/// it.

namespace microslip {

/// minimise ½xᵀHx − gᵀx  subject to  x ≥ 0 and mᵀx ≤ budget.
///
/// H is symmetric positive definite, m ≥ 0 and budget > 0, so there is one minimiser. With the
/// multiplier μ of the budget, x is it exactly when
///
///     s = Hx − g + μm ≥ 0,  x ≥ 0,  xᵀs = 0,  μ ≥ 0,  μ(budget − mᵀx) = 0           (KKT)
class QuadraticProgram {
 public:
  struct Solution {
    Eigen::VectorXd x;
    double multiplier = 0.0;    ///< μ
    std::vector<bool> free;     ///< not fixed at 0
    int exchanges = 0;          ///< how often the set of free variables was changed
    double kkt_residual = 0.0;  ///< largest violation of (KKT), relative; see solve()
    double rounding = 0.0;      ///< the part that may be the rounding of x to doubles
    bool converged = false;

    /// Whether it converged, and (KKT) holds to 1e−9 or rounding.
    [[nodiscard]] bool optimal() const {
      return converged && kkt_residual <= kMostKktResidual + rounding;
    }
  };

  static constexpr double kMostKktResidual = 1e-9;

  /// @param budget_weights  m, one per variable.
  QuadraticProgram(Eigen::VectorXd budget_weights, double budget);

  /// Block principal pivoting (Portugal, Júdice & Vicente, Math. Comp. 63 (1994) 625), the
  /// multiplier eliminated on each set of free variables. With the budget it may cycle: where a few
  /// exchanges make no progress, a descending active-set method completes the solution. It stops
  /// when all signs are right to 1e−12 of the largest x and 1e−10 of the largest |g|, but for
  /// the rounding of Hx.
  ///
  /// The residual is the largest of |s_i| over the free and −s_i over the others relative to ‖g‖∞,
  /// −x_i relative to ‖x‖∞ and mᵀx − budget relative to the budget; infinite where H is not
  /// positive definite to rounding.
  ///
  /// @param start  variables free at first: with those of a similar problem one exchange is enough.
  [[nodiscard]] Solution solve(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                               std::vector<bool> start);

 private:
  [[nodiscard]] bool solve_on_free(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                   Solution& solution);
  [[nodiscard]] bool pivot_blocks(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                  Solution& solution);
  [[nodiscard]] bool go_downhill(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                 Solution& solution);
  [[nodiscard]] double kkt_residual(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                    const Solution& solution) const;

  Eigen::VectorXd budget_weights_;
  double budget_;

  // Working storage, kept between solves.
  std::vector<Eigen::Index> index_;
  Eigen::MatrixXd reduced_;
  Eigen::MatrixXd right_;
  Eigen::VectorXd slack_;
  Eigen::VectorXd magnitude_;  // Σ_j |H_ij x_j|
  double slack_rounding_ = 0.0;
};

/// Enters a solution in a summary: whether (KKT) holds, and to which residual.
/// @param what  the start of the reason, such as "optimality conditions".
void read_optimality(const QuadraticProgram::Solution& solution, std::string_view what,
                     Summary& summary);

/// Indices of the coefficients that are not fixed at 0.
[[nodiscard]] std::vector<Eigen::Index> free_coefficients(
    const QuadraticProgram::Solution& solution);

}  // namespace microslip
