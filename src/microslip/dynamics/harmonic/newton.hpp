// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/harmonic/balance_equations.hpp"
#include "microslip/dynamics/harmonic/bordered_factors.hpp"

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
  int kept = 0;           ///< steps by factors of the one before
  std::string reason;
};

/// Newton's method on the balance and two more conditions from z, in relative unknowns; a step that
/// makes the residual larger is halved up to four times. It ends when each |R_j|/|u_j| and each
/// miss of a condition is at most the tolerance, or when below 1e-10 they fall no further:
/// rounding. A negative force amplitude is no solution. Where it does not converge z is the best
/// that was found; on return the equations are evaluated at z.
///
/// Where there are many unknowns the factors of a step serve the next ones too (chord method), as
/// long as that gets to the tolerance in fewer evaluations than new factors cost.
/// @param factors  on return those of the last step, made near z.
NewtonResult newton(BalanceEquations& equations, const Target& first, const Target& second,
                    const NewtonOptions& options, Eigen::VectorXd& z, BorderedFactors& factors);
NewtonResult newton(BalanceEquations& equations, const Target& first, const Place& second,
                    const NewtonOptions& options, Eigen::VectorXd& z, BorderedFactors& factors);
NewtonResult newton(BalanceEquations& equations, const Target& first, const Onset& second,
                    const NewtonOptions& options, Eigen::VectorXd& z, BorderedFactors& factors);
NewtonResult newton(BalanceEquations& equations, const Target& first, const Tie& second,
                    const NewtonOptions& options, Eigen::VectorXd& z, BorderedFactors& factors);
/// Without a need for the factors.
NewtonResult newton(BalanceEquations& equations, const Target& first, const Target& second,
                    const NewtonOptions& options, Eigen::VectorXd& z);
NewtonResult newton(BalanceEquations& equations, const Target& first, const Place& second,
                    const NewtonOptions& options, Eigen::VectorXd& z);

}  // namespace microslip
