// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"

/// @file
/// Extremes of the coefficients that levels leave possible. Internal: Eigen stays out of the
/// installed headers.

namespace microslip {

/// −2 ln p = λ‖Lx‖² + Σ ‖R_g x − z_g‖²/s_g² of coefficients x ≥ 0 with areaᵀx ≤ 1, and the extremes
/// of those where it is not above its minimum by more than z².
class PossibleCoefficients {
 public:
  static constexpr double kNineteenOfTwenty = 3.841;  ///< z² of 95 %

  /// @param penalty  L. @param lambda  λ > 0.
  /// @param area     of each coefficient.
  PossibleCoefficients(const Eigen::MatrixXd& penalty, double lambda, Eigen::VectorXd area);

  /// Adds rows of one kind. @param factor  R. @param data  z. @param scatter  s > 0.
  void add(const Eigen::MatrixXd& factor, const Eigen::VectorXd& data, double scatter);

  /// x of the largest value of a goal, to first order about each solution on the way.
  /// @param gradient  of the goal at x. @param rise  z².
  [[nodiscard]] Eigen::VectorXd extreme(
      const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& gradient, double rise);

 private:
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& more);

  Eigen::MatrixXd hessian_;
  Eigen::VectorXd linear_;
  Eigen::VectorXd area_;
  QuadraticProgram program_;
  std::vector<bool> free_;
};

}  // namespace microslip
