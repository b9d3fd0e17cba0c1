// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/random.hpp"

/// @file
/// Draws from a Gaussian within linear limits. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// x_j ≥ 0 for the first `positive` coefficients, and mᵀx ≤ 1 of each budget.
struct LinearLimits {
  Eigen::Index positive = 0;
  Eigen::MatrixXd budget_weights;  ///< m ≥ 0: coefficients × budgets; 0 for no such limit

  /// Whether x satisfies them.
  [[nodiscard]] bool hold(const Eigen::VectorXd& x) const;

  /// x with coefficients on a limit moved inside.
  /// @param least  coefficients below this are moved to it, > 0.
  [[nodiscard]] Eigen::VectorXd moved_inside(const Eigen::VectorXd& x,
                                             const Eigen::VectorXd& least) const;
};

/// Draws from  p(x) ∝ exp(−½xᵀHx + gᵀx)  within limits, each starting from the one before
/// it.
///
/// Hamiltonian trajectories of a quarter period, which are closed forms of sine and cosine, with
/// exact reflections at the limits: no draw is rejected, there is no step, and the distribution is
/// stationary [Pakman & Paninski, J. Comput. Graph. Stat. 23 (2014) 518].
class TruncatedGaussian {
 public:
  static constexpr int kNoEnd = std::numeric_limits<int>::max();

  explicit TruncatedGaussian(LinearLimits limits) : limits_(std::move(limits)) {}

  /// Another Gaussian within the same limits.
  /// @param hessian  H, symmetric positive definite, but for rounding.
  /// @param linear   g.
  /// @throws InputError  where they are not finite.
  void set(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear);

  /// Other limits for the draws to come, which the last one is within.
  void set_limits(LinearLimits limits) {
    limits_ = std::move(limits);
    limits_set_ = false;
  }

  /// ln of the integral of exp(−½xᵀHx + gᵀx) without the limits, less ½n ln 2π.
  [[nodiscard]] double log_integral() const;

  /// Standard deviation of each coefficient without the limits.
  [[nodiscard]] Eigen::VectorXd standard_deviation() const;

  /// Coordinates z in which it is N(0, 1) without the limits: x = mean + L⁻ᵀz, H = LLᵀ.
  [[nodiscard]] Eigen::VectorXd standardised(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd from_standardised(const Eigen::VectorXd& z) const;

  /// The next draw.
  /// @param x                 the last one, within the limits; replaced.
  /// @param random            gives one normal number per coefficient.
  /// @param most_reflections  ends the trajectory there, which is then no draw: to find a start.
  void move(Eigen::VectorXd& x, RandomStream& random, int most_reflections = kNoEnd);

  /// How often each coefficient was reflected by its limit on the last trajectory.
  [[nodiscard]] const std::vector<int>& reflections() const { return reflections_; }

 private:
  struct Hit {
    double time;
    Eigen::Index limit;
  };
  void prepare_limits();
  [[nodiscard]] Hit next_hit(double before, Eigen::Index last) const;
  void reflect(Eigen::Index limit);

  LinearLimits limits_;
  Eigen::MatrixXd factor_;  // L
  Eigen::VectorXd mean_;
  Eigen::VectorXd half_;  // L⁻¹g
  bool limits_set_ = false;
  // Limits fᵀz + offset ≥ 0, each in its own standard deviations; f is a column of normals_.
  Eigen::MatrixXd normals_;
  Eigen::VectorXd offset_;
  // fᵀf' of a limit with all: most are met often, or never, so that each is found when it is met.
  Eigen::MatrixXd cosines_;
  std::vector<bool> has_cosines_;
  Eigen::VectorXd position_;  // z
  Eigen::VectorXd velocity_;
  Eigen::VectorXd position_of_limits_;  // fᵀz
  Eigen::VectorXd velocity_of_limits_;
  std::vector<int> reflections_;
};

}  // namespace microslip
