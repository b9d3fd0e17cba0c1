// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"

namespace microslip {

/// Correction of the harmonics from sums over samples of a force with kinks. Internal to dynamics.
///
/// The harmonics are ∮ fT dτ, for which h Σ fT errs by the order h² where f has kinks. They are
/// known: where the derivatives of g = fT jump by [g′], [g″] at the share θ of an interval, Euler
/// and Maclaurin's formula with Bernoulli's polynomials gives
///
///     ∮ g dτ = h Σ g + h² [g′] B_2(θ)/2 − h³ [g″] B_3(θ)/6 + …
///
/// A tangent that jumps by Δ makes [f′] = Δẋ and, but for a jump of F″, [f″] = Δẍ. Both terms are
/// needed: where slip sets in just before a reversal, its kink and the reversal cancel, and their
/// sum is smooth in the motion. In the derivatives by the motion, with the place following it,
/// terms to the order of h in h Σ g are kept.
class KinkCorrection {
 public:
  KinkCorrection(std::size_t harmonics, std::size_t samples);

  /// Starts anew. @param coefficients  of x, kept by reference. @param wave  which those are; rows
  /// and what is found have all.
  void reset(std::span<const double> coefficients, Wave wave);

  /// A reversal: the tangent jumps while the velocity is 0.
  /// @param tau           in the interval of samples that ends with `next`.
  /// @param acceleration  d²x/dτ² there.
  /// @param row           T(τ).
  /// @param jump          of the tangent, N/m.
  void add_turn(double tau, Eigen::Index next, double acceleration,
                const Eigen::Ref<const Eigen::VectorXd>& row, double jump);

  /// A jump of the tangent where x passes x_ref + constant.
  /// @param reference  T where x is x_ref.
  /// @param gradient   of the jump by the coefficients of x.
  void add_kink(double tau, double jump, const Eigen::Ref<const Eigen::VectorXd>& reference,
                const Eigen::Ref<const Eigen::VectorXd>& gradient);

  /// To be added to Σ f T, and its derivatives by the coefficients of x.
  [[nodiscard]] const Eigen::VectorXd& sums() const { return sums_; }
  [[nodiscard]] const Eigen::MatrixXd& derivatives() const { return derivatives_; }

 private:
  double step_;  // h, rad
  std::span<const double> coefficients_;
  Wave wave_ = Wave::kAny;
  Eigen::VectorXd row_;
  Eigen::VectorXd slope_;  // dT/dτ
  Eigen::VectorXd sums_;
  Eigen::MatrixXd derivatives_;
};

}  // namespace microslip
