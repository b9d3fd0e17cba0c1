// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "microslip/base/random.hpp"
#include "microslip/identify/smoothing_path.hpp"

/// @file
/// Draws from what data and prior leave possible. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// A Markov chain of coefficients with the smoothing and the scatter, none of them fixed:
///
///     p(x, λ, τ² | d) ∝ τ^−(m+2) exp(−‖Dx − d‖²/2τ²) · λ^(r/2 − 1) exp(−½λ‖Lx‖²)
///
/// within x ≥ 0, mᵀx ≤ 1 of a SmoothingProblem with m rows D and r rows L, both of scale-free
/// priors: x | λ, τ by TruncatedGaussian, λ | x from a Gamma and τ² | x from a scaled inverse χ²
/// distribution (Gibbs). λ stays between the ends of the problem's path: where a density as smooth
/// as can be is possible, so is any λ above.
class PosteriorChain {
 public:
  /// @param problem  must outlive this; rows in units of their scatter, so that τ is near 1.
  /// @param lambda   where it starts: that of a good solution.
  /// @param start    that solution.
  PosteriorChain(const SmoothingProblem& problem, double lambda, const Eigen::VectorXd& start);

  /// The next draw; alike to the one before it.
  const Eigen::VectorXd& next(RandomStream& random);

  [[nodiscard]] double lambda() const { return lambda_; }  ///< of the last draw
  [[nodiscard]] double scale() const { return scale_; }    ///< τ of the last draw

 private:
  void draw_lambda(RandomStream& random);
  void draw_scale(RandomStream& random);

  const SmoothingProblem& problem_;
  Eigen::MatrixXd information_;
  Eigen::MatrixXd roughness_;
  double least_lambda_;
  double most_lambda_;
  double lambda_;
  double scale_ = 1.0;
  Eigen::VectorXd x_;
};

}  // namespace microslip
