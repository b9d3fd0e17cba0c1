// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include "microslip/dynamics/balance_equations.hpp"

namespace microslip {

/// A linear condition on z, g(z − z₀) = 0 with g relative: a place on a curve. Internal to
/// dynamics.
struct Place {
  Eigen::VectorXd at;
  Eigen::RowVectorXd normal;
};

struct NewtonOptions {
  double tolerance;
  int max_iterations;
};

struct NewtonResult {
  bool converged = false;
  double residual = 0.0;  ///< the largest relative residual
  int iterations = 0;     ///< evaluations of the equations
  std::string reason;
};

/// Newton's method on the balance and two more conditions from z, in relative unknowns; a step that
/// makes the residual larger is halved up to four times. It ends when each |R_j|/|u_j| and each
/// miss of a condition is at most the tolerance, or when below 1e-10 they fall no further:
/// rounding. A negative force amplitude is no solution. Where it does not converge z is the best
/// that was found; on return the equations are evaluated at z.
NewtonResult newton(BalanceEquations& equations, const Target& first, const Target& second,
                    const NewtonOptions& options, Eigen::VectorXd& z);
NewtonResult newton(BalanceEquations& equations, const Target& first, const Place& second,
                    const NewtonOptions& options, Eigen::VectorXd& z);
NewtonResult newton(BalanceEquations& equations, const Target& first, const Onset& second,
                    const NewtonOptions& options, Eigen::VectorXd& z);

}  // namespace microslip
