// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

/// @file
/// The unknowns of the inversion and what they do to D and k_eq. Internal: Eigen stays out of the
/// installed headers.
///
/// All in scaled variables: amplitude a = A/A_max, slip force s = f*/(kA_max), density p = kA_max
/// φ, dissipation d = D/(kA_max²), softening 1 − k_eq/k.

namespace microslip {

/// The density is continuous and linear between knots, and constant below the first; so the result
/// is written without loss as a piecewise-linear part. The coefficients θ are what the roughness
/// penalty sees: p at knot j is reference_j θ_j. With the reference s^χ₀ (χ₀ from the log–log slope
/// of D) a power law is a constant θ and costs nothing. The first coefficient carries the knots
/// below the lowest amplitude along: D tells only two moments of the density there.
class InversionBasis {
 public:
  /// @param lowest        lowest scaled amplitude, in (0, 1).
  /// @param top           where the density ends, in (lowest, 1].
  /// @param exponent      χ₀, in (−1, 0].
  /// @param coefficients  how many θ; ≥ 4.
  InversionBasis(double lowest, double top, double exponent, int coefficients);

  [[nodiscard]] Eigen::Index size() const { return coefficients_; }

  /// Knots s, rising.
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }

  /// p at the knots from θ: a matrix of knots × coefficients.
  [[nodiscard]] const Eigen::MatrixXd& nodal() const { return nodal_; }

  /// d of each amplitude from θ, (7): amplitudes × coefficients.
  [[nodiscard]] Eigen::MatrixXd dissipation(const Eigen::VectorXd& amplitude) const;

  /// 1 − k_eq/k of each amplitude from θ: amplitudes × coefficients.
  [[nodiscard]] Eigen::MatrixXd softening(const Eigen::VectorXd& amplitude) const;

  /// Area ∫p ds from θ.
  [[nodiscard]] Eigen::VectorXd area() const;

  /// Second differences of θ over the coordinate in which the knots are equally spaced, with its
  /// range as the unit: rows (size − 2) × size.
  [[nodiscard]] Eigen::MatrixXd second_differences() const;

 private:
  Eigen::Index coefficients_;
  std::vector<double> knots_;
  Eigen::MatrixXd nodal_;
};

}  // namespace microslip
