// SPDX-License-Identifier: MIT
#include "microslip/dynamics/trigonometric_basis.hpp"

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

std::complex<double> harmonic_of(const Eigen::Ref<const VectorXd>& x, std::size_t n) {
  const Index at = coefficient_index(n);
  return n == 0 ? std::complex<double>(x[0]) : std::complex<double>(x[at], x[at + 1]);
}

Motion motion_at(std::span<const double> coefficients, double tau) {
  Motion motion{coefficients[0], 0.0, 0.0};
  const double c = std::cos(tau);
  const double s = std::sin(tau);
  double cn = 1.0;
  double sn = 0.0;
  for (std::size_t i = 1; i + 1 < coefficients.size(); i += 2) {
    const double next = cn * c - sn * s;
    sn = sn * c + cn * s;
    cn = next;
    const auto n = static_cast<double>((i + 1) / 2);
    const double along = coefficients[i] * cn - coefficients[i + 1] * sn;
    motion.value += along;
    motion.velocity -= n * (coefficients[i] * sn + coefficients[i + 1] * cn);
    motion.acceleration -= n * n * along;
  }
  return motion;
}

void basis_at(double tau, Eigen::Ref<VectorXd> row) {
  row[0] = 1.0;
  const double c = std::cos(tau);
  const double s = std::sin(tau);
  double cn = 1.0;
  double sn = 0.0;
  for (Index i = 1; i + 1 < row.size(); i += 2) {
    const double next = cn * c - sn * s;
    sn = sn * c + cn * s;
    cn = next;
    row[i] = cn;
    row[i + 1] = -sn;
  }
}

void derivative_of_basis(const Eigen::Ref<const VectorXd>& row, Eigen::Ref<VectorXd> slope) {
  slope[0] = 0.0;
  for (Index i = 1; i + 1 < row.size(); i += 2) {
    const auto n = static_cast<double>((i + 1) / 2);
    slope[i] = n * row[i + 1];
    slope[i + 1] = -n * row[i];
  }
}

// Row a and column b: (w_a/2π) ∮ t T_a T_b dτ by the product formulas of sine and cosine, from the
// moments of t: ∮ t cos mτ dτ/π = Re t_m and −∮ t sin mτ dτ/π = Im t_m for m ≥ 1,
// with 2t_0 at m = 0.
Eigen::MatrixXd multiplication_matrix(const Eigen::Ref<const VectorXd>& t, std::size_t harmonics) {
  const auto order = static_cast<Index>(harmonics);
  const auto moment = [&](Index m) {  // of |m|; the sine part is odd in m
    const Index at = coefficient_index(static_cast<std::size_t>(std::abs(m)));
    if (at >= t.size()) return std::complex<double>(0.0);
    if (m == 0) return std::complex<double>(2.0 * t[0]);
    return std::complex<double>(t[at], m < 0 ? -t[at + 1] : t[at + 1]);
  };
  Eigen::MatrixXd c(2 * order + 1, 2 * order + 1);
  for (Index a = 0; a <= order; ++a) {
    const double weight = a == 0 ? 0.25 : 0.5;
    const Index i = coefficient_index(static_cast<std::size_t>(a));
    for (Index b = 0; b <= order; ++b) {
      const Index j = coefficient_index(static_cast<std::size_t>(b));
      const std::complex<double> sum = moment(a + b);
      const std::complex<double> difference = moment(a - b);
      c(i, j) = weight * (difference.real() + sum.real());
      if (b > 0) c(i, j + 1) = weight * (sum.imag() - difference.imag());
      if (a > 0) c(i + 1, j) = weight * (sum.imag() + difference.imag());
      if (a > 0 && b > 0) c(i + 1, j + 1) = weight * (difference.real() - sum.real());
    }
  }
  return c;
}

TrigonometricBasis::TrigonometricBasis(std::size_t harmonics, std::size_t samples)
    : harmonics_(harmonics),
      rows_(static_cast<Index>(samples), coefficient_count(2 * harmonics)),
      sums_(static_cast<Index>(samples) + 1, coefficient_count(harmonics)),
      weights_(
          VectorXd::Constant(coefficient_count(harmonics), 2.0 / static_cast<double>(samples))) {
  weights_[0] = 1.0 / static_cast<double>(samples);
  // The angle of each product n k is reduced to one period in integers: no digits are lost to a
  // large one, and one turn of sines serves all.
  const Index count = rows_.rows();
  VectorXd cosine(count);
  VectorXd sine(count);
  for (Index k = 0; k < count; ++k) {
    const double tau = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    cosine[k] = std::cos(tau);
    sine[k] = std::sin(tau);
  }
  rows_.col(0).setOnes();
  for (std::size_t n = 1; n <= 2 * harmonics; ++n) {
    const Index column = coefficient_index(n);
    Index turn = 0;
    for (Index k = 0; k < count; ++k) {
      rows_(k, column) = cosine[turn];
      rows_(k, column + 1) = -sine[turn];
      turn += static_cast<Index>(n);
      if (turn >= count) turn -= count;  // n < N
    }
  }
  sums_.row(0).setZero();
  for (Index j = 0; j < sums_.cols(); ++j) {
    for (Index k = 0; k < count; ++k) sums_(k + 1, j) = sums_(k, j) + rows_(k, j);
  }
}

}  // namespace microslip
