// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "microslip/base/random.hpp"

/// @file
/// Draws from a Gaussian within linear limits. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// A chain of draws from  p(x) ∝ exp(−½xᵀHx + gᵀx)  subject to  x ≥ 0 and mᵀx ≤ 1.
///
/// Hamiltonian trajectories of a quarter period, which are closed forms of sine and cosine, with
/// exact reflections at the limits: no draw is rejected, there is no step, and the distribution is
/// stationary [Pakman & Paninski, J. Comput. Graph. Stat. 23 (2014) 518].
class TruncatedGaussian {
 public:
  /// @param hessian         H, symmetric positive definite.
  /// @param linear          g.
  /// @param budget_weights  m ≥ 0; 0 for no such limit.
  /// @param start           within the limits; coefficients at 0 are moved a little inside.
  TruncatedGaussian(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                    const Eigen::VectorXd& budget_weights, const Eigen::VectorXd& start);

  /// The next draw. @param random  a normal number a coefficient.
  const Eigen::VectorXd& next(RandomStream& random);

 private:
  struct Hit {
    double time;
    Eigen::Index limit;
  };
  [[nodiscard]] Hit next_hit(double before, Eigen::Index last) const;

  // x = mean + Cz with z ~ N(0, 1); limits f z + offset ≥ 0.
  Eigen::VectorXd mean_;
  Eigen::MatrixXd from_standard_;  // C = L⁻ᵀ, H = LLᵀ
  Eigen::MatrixXd limits_;         // f: limits × coefficients
  Eigen::MatrixXd gram_;           // f fᵀ
  Eigen::VectorXd offset_;
  Eigen::VectorXd position_;  // z
  Eigen::VectorXd velocity_;
  Eigen::VectorXd position_of_limits_;  // f z
  Eigen::VectorXd velocity_of_limits_;
  Eigen::VectorXd x_;
};

}  // namespace microslip
