// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/signal/harmonic/harmonic_basis.hpp"

namespace microslip {

/// The linear least-squares fit of all signals at one Ω = ω·half_width, and how it changes with Ω.
/// Unknowns a of a signal: mean and trend (Legendre polynomials 0 … K), then Re c_1, Im c_1,
/// Re c_2, …, with the zero of time in the middle of the record. Internal to signal.
struct HarmonicFit {
  double big_omega = 0.0;
  Eigen::Index order = 0;        ///< H
  Eigen::MatrixXd coefficients;  ///< a, unknowns × signals
  Eigen::VectorXd squares;       ///< RSS per signal
  Eigen::VectorXd gradient;      ///< ½ dRSS/dΩ
  Eigen::VectorXd rounding;      ///< how far rounding may move the gradient
  Eigen::VectorXd curvature;     ///< |P x′|², x′ = ∂x/∂Ω at fixed a, P off all columns
  Eigen::MatrixXd slope;         ///< Aᵀx′, unknowns × signals
  Eigen::LLT<Eigen::MatrixXd> gram;  ///< of AᵀA
  bool determined = false;           ///< AᵀA is regular; all else is empty where it is not

  [[nodiscard]] Eigen::Index unknowns() const { return coefficients.rows(); }
  /// c_1 … c_H: H × signals.
  [[nodiscard]] Eigen::MatrixXcd harmonics() const;
  /// i n c_n, the coefficients of x′/s: H × signals.
  [[nodiscard]] Eigen::MatrixXcd turned_harmonics() const;
};

/// The signals of a record, and their fit at any Ω. Internal to signal.
class HarmonicRegression {
 public:
  /// @param times    must outlive this.
  /// @param signals  points × signals; of the order of 1, without mean.
  /// @param degree   K, of the trend.
  HarmonicRegression(const RecordTimes& times, const Eigen::MatrixXd& signals, Eigen::Index degree);

  [[nodiscard]] HarmonicFit fit(double big_omega, Eigen::Index order) const;
  /// Residuals of the signals.
  [[nodiscard]] Eigen::MatrixXd residuals(const HarmonicFit& fit) const;

  [[nodiscard]] const RecordTimes& times() const { return times_; }
  [[nodiscard]] Eigen::Index signals() const { return square_.size(); }
  [[nodiscard]] Eigen::Index degree() const { return degree_; }
  /// Σ y² per signal.
  [[nodiscard]] const Eigen::VectorXd& square() const { return square_; }
  /// RSS, but not less than (ε points)² Σ y²: the phase of a harmonic at half of the sampling rate,
  /// π/2 points rad at the ends of the record, is not known better, and below differences are
  /// rounding.
  [[nodiscard]] Eigen::VectorXd floored(const Eigen::VectorXd& squares) const;
  /// P_0(s) … P_K(s) at the points of the range.
  [[nodiscard]] Eigen::MatrixXd polynomials(PointRange range) const;

 private:
  [[nodiscard]] Eigen::MatrixXd gram(const Eigen::MatrixXcd& moments, Eigen::Index order,
                                     Eigen::Index weight) const;
  [[nodiscard]] Eigen::MatrixXd normal_matrix(const Eigen::MatrixXcd& moments,
                                              Eigen::Index order) const;
  void fill_squares(const Eigen::MatrixXd& right, HarmonicFit& fit) const;

  const RecordTimes& times_;
  Eigen::Index degree_;
  Eigen::MatrixXd legendre_;  ///< P_q = Σ_r legendre_(q, r) s^r
  Eigen::MatrixXd columns_;   ///< y and s y: points × 2·signals
  Eigen::VectorXd square_;
  Eigen::MatrixXd polynomial_sums_;  ///< Σ P_q y: (K + 1) × signals
};

/// Legendre polynomials 0 … degree at s, by columns.
[[nodiscard]] Eigen::MatrixXd legendre_at(const Eigen::VectorXd& s, Eigen::Index degree);

}  // namespace microslip
