// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/harmonic_regression.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// RSS/Σ y² below which the difference Σ y² − aᵀAᵀy has lost so many digits that the weights of the
/// signals, 1/RSS, would change from one Ω to the next by rounding alone.
constexpr double kCancelled = 1e-8;
/// Reciprocal condition number of AᵀA below which the points do not determine the unknowns.
constexpr double kLeastCondition = 1e-10;

/// P_q = Σ_r c(q, r) s^r, by (q + 1) P_{q+1} = (2q + 1) s P_q − q P_{q−1}.
Eigen::MatrixXd legendre_coefficients(Index degree) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
  c(0, 0) = 1.0;
  if (degree > 0) c(1, 1) = 1.0;
  for (Index q = 1; q < degree; ++q) {
    const double n = static_cast<double>(q);
    c.row(q + 1).tail(degree) = (2.0 * n + 1.0) / (n + 1.0) * c.row(q).head(degree);
    c.row(q + 1) -= n / (n + 1.0) * c.row(q - 1);
  }
  return c;
}

/// Σ s^w A_hᵀA_h for the columns Re z_n, Im z_n from Σ s^w z_k, k = 0 … 2H: the products of
/// sines are sines of sums and differences.
Eigen::MatrixXd harmonic_products(const Eigen::RowVectorXcd& sums, Index order) {
  const auto z = [&sums](Index k) { return k < 0 ? std::conj(sums(-k)) : sums(k); };
  Eigen::MatrixXd g(2 * order, 2 * order);
  for (Index n = 1; n <= order; ++n) {
    for (Index m = 1; m <= order; ++m) {
      const Complex difference = 0.5 * z(m - n);
      const Complex sum = 0.5 * z(n + m);
      g(2 * n - 2, 2 * m - 2) = difference.real() + sum.real();
      g(2 * n - 1, 2 * m - 1) = difference.real() - sum.real();
      g(2 * n - 2, 2 * m - 1) = sum.imag() + difference.imag();
      g(2 * n - 1, 2 * m - 2) = sum.imag() - difference.imag();
    }
  }
  return g;
}

/// aᵀb by columns.
Eigen::VectorXd dots(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.cwiseProduct(b).colwise().sum().transpose();
}

Eigen::ArrayXd norms(const Eigen::MatrixXd& columns) {
  return columns.colwise().norm().transpose().array();
}

/// Complex rows as pairs of real ones: Re of row 0, Im of row 0, Re of row 1, …
Eigen::MatrixXd as_pairs(const Eigen::MatrixXcd& rows) {
  return Eigen::Map<const Eigen::MatrixXd>(reinterpret_cast<const double*>(rows.data()),
                                           2 * rows.rows(), rows.cols());
}

}  // namespace

Eigen::MatrixXd legendre_at(const Eigen::VectorXd& s, Index degree) {
  Eigen::MatrixXd p(s.size(), degree + 1);
  p.col(0).setOnes();
  if (degree > 0) p.col(1) = s;
  for (Index q = 1; q < degree; ++q) {
    const double n = static_cast<double>(q);
    p.col(q + 1) = ((2.0 * n + 1.0) * s.cwiseProduct(p.col(q)) - n * p.col(q - 1)) / (n + 1.0);
  }
  return p;
}

Eigen::MatrixXcd HarmonicFit::harmonics() const {
  const Eigen::MatrixXd pairs = coefficients.bottomRows(2 * order);
  return Eigen::Map<const Eigen::MatrixXcd>(reinterpret_cast<const Complex*>(pairs.data()), order,
                                            pairs.cols());
}

Eigen::MatrixXcd HarmonicFit::turned_harmonics() const {
  const Eigen::VectorXcd factor =
      Complex(0.0, 1.0) *
      Eigen::VectorXd::LinSpaced(order, 1.0, static_cast<double>(order)).cast<Complex>();
  return factor.asDiagonal() * harmonics();
}

HarmonicRegression::HarmonicRegression(const RecordTimes& times, const Eigen::MatrixXd& signals,
                                       Index degree)
    : times_(times),
      degree_(degree),
      legendre_(legendre_coefficients(degree)),
      columns_(signals.rows(), 2 * signals.cols()),
      square_(signals.colwise().squaredNorm().transpose()) {
  columns_.leftCols(signals.cols()) = signals;
  const Eigen::MatrixXd p = polynomials({0, times.points()});
  const Eigen::VectorXd s =
      Eigen::VectorXd::NullaryExpr(times.points(), [&times](Index i) { return times.s(i); });
  columns_.rightCols(signals.cols()) = s.asDiagonal() * signals;
  polynomial_sums_ = p.transpose() * signals;
}

Eigen::MatrixXd HarmonicRegression::polynomials(PointRange range) const {
  const Eigen::VectorXd s = Eigen::VectorXd::NullaryExpr(
      range.size(), [&](Index i) { return times_.s(range.first + i); });
  return legendre_at(s, degree_);
}

Eigen::VectorXd HarmonicRegression::floored(const Eigen::VectorXd& squares) const {
  const double phase = kEpsilon * static_cast<double>(times_.points());
  return squares.cwiseMax(phase * phase * square_);
}

/// Aᵀ s^weight A_h: all unknowns × those of the harmonics.
Eigen::MatrixXd HarmonicRegression::gram(const Eigen::MatrixXcd& moments, Index order,
                                         Index weight) const {
  Eigen::MatrixXd g(degree_ + 1 + 2 * order, 2 * order);
  const Eigen::MatrixXcd polynomial = legendre_ * moments.block(weight, 1, degree_ + 1, order);
  for (Index n = 0; n < order; ++n) {
    g.col(2 * n).head(degree_ + 1) = polynomial.col(n).real();
    g.col(2 * n + 1).head(degree_ + 1) = polynomial.col(n).imag();
  }
  g.bottomRows(2 * order) = harmonic_products(moments.row(weight), order);
  return g;
}

Eigen::MatrixXd HarmonicRegression::normal_matrix(const Eigen::MatrixXcd& moments,
                                                  Index order) const {
  const Index constants = degree_ + 1;
  const Eigen::MatrixXd hankel = Eigen::MatrixXd::NullaryExpr(
      constants, constants, [&moments](Index q, Index r) { return moments(q + r, 0).real(); });
  Eigen::MatrixXd normal(constants + 2 * order, constants + 2 * order);
  normal.topLeftCorner(constants, constants) = legendre_ * hankel * legendre_.transpose();
  normal.rightCols(2 * order) = gram(moments, order, 0);
  normal.bottomLeftCorner(2 * order, constants) =
      normal.topRightCorner(constants, 2 * order).transpose();
  return normal;
}

HarmonicFit HarmonicRegression::fit(double big_omega, Index order) const {
  const PointRange all{0, times_.points()};
  const HarmonicBasis basis(times_, big_omega, 2 * order);
  const Eigen::MatrixXcd moments = basis.moments(std::max(2 * degree_, degree_ + 2), all);
  HarmonicFit fit;
  fit.big_omega = big_omega;
  fit.order = order;
  fit.gram.compute(normal_matrix(moments, order));
  fit.determined = fit.gram.info() == Eigen::Success && fit.gram.rcond() > kLeastCondition;
  if (!fit.determined) return fit;

  const Eigen::MatrixXcd sums = basis.sums(columns_, all, order);
  const Index count = signals();
  Eigen::MatrixXd right(degree_ + 1 + 2 * order, count);  // Aᵀy
  right << polynomial_sums_, as_pairs(sums.leftCols(count));
  fit.coefficients = fit.gram.solve(right);
  fill_squares(right, fit);

  const Eigen::MatrixXd turned = as_pairs(fit.turned_harmonics());
  const Eigen::MatrixXd weighted = as_pairs(sums.rightCols(count));  // A_hᵀ s y
  fit.slope = gram(moments, order, 1) * turned;
  fit.gradient = dots(fit.coefficients, fit.slope) - dots(turned, weighted);
  const Eigen::MatrixXd squared = gram(moments, order, 2).bottomRows(2 * order) * turned;
  const Eigen::VectorXd square_of_slope = dots(turned, squared);  // |x′|²
  const Eigen::MatrixXd g = fit.gram.solve(fit.slope);
  fit.curvature = square_of_slope - dots(fit.slope, g);
  // Each sum over the record is off by some √points roundings of terms as large as its factors:
  // those with x′ directly, those of Aᵀy and AᵀA by what they move a.
  const double root = std::sqrt(static_cast<double>(times_.points()));
  const Eigen::ArrayXd size = square_.cwiseSqrt().array();
  fit.rounding = kEpsilon * root *
                 (size * square_of_slope.cwiseMax(0.0).cwiseSqrt().array() +
                  root * (size + root * norms(fit.coefficients)) * norms(g));
  return fit;
}

/// Σ y² − aᵀAᵀy, or from the residuals where that difference is rounding.
void HarmonicRegression::fill_squares(const Eigen::MatrixXd& right, HarmonicFit& fit) const {
  fit.squares = square_ - dots(fit.coefficients, right);
  if ((fit.squares.array() > kCancelled * square_.array()).all()) return;
  fit.squares = residuals(fit).colwise().squaredNorm().transpose();
}

Eigen::MatrixXd HarmonicRegression::residuals(const HarmonicFit& fit) const {
  Eigen::MatrixXd left = columns_.leftCols(signals());
  const PointRange all{0, times_.points()};
  left.noalias() -= polynomials(all) * fit.coefficients.topRows(degree_ + 1);
  HarmonicBasis(times_, fit.big_omega, fit.order).subtract_series(fit.harmonics(), left);
  return left;
}

}  // namespace microslip
