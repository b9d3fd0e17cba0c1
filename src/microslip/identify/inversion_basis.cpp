// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion_basis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// The knots reach this many e-folds below the lowest amplitude, and the tail, one knot an e-fold,
/// these further down.
constexpr double kFoldsBelow = 1.5;
constexpr int kTailKnots = 3;

}  // namespace

// Equally spaced in s^P, P ≤ ½: at equal relative scatter of D the width that can be resolved grows
// as A^0.8, so this is finer than the data at the top and follows them down over any number of
// decades.
InversionBasis::InversionBasis(double lowest, double top, double exponent, int coefficients)
    : coefficients_(coefficients) {
  const double first = std::min(lowest, 0.5 * top) * std::exp(-kFoldsBelow);
  const double power = std::min(0.5, std::log(10.0) / std::log(1.0 / first));
  for (int i = kTailKnots; i > 0; --i) knots_.push_back(first * std::exp(-i));
  const double from = std::pow(first, power);
  const double to = std::pow(top, power);
  for (int j = 0; j < coefficients; ++j) {
    const double v = from + (to - from) * j / (coefficients - 1);
    knots_.push_back(std::pow(v, 1.0 / power));
  }
  knots_[kTailKnots] = first;
  knots_.back() = top;

  nodal_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(knots_.size()), coefficients_);
  for (Eigen::Index j = 0; j < nodal_.rows(); ++j) {
    const double reference = std::pow(knots_[static_cast<std::size_t>(j)], exponent);
    nodal_(j, std::max<Eigen::Index>(0, j - kTailKnots)) = reference;
  }
}

Eigen::MatrixXd InversionBasis::dissipation(const Eigen::VectorXd& amplitude) const {
  return dissipation_rows(amplitude, knots_) * nodal_;
}

Eigen::MatrixXd InversionBasis::softening(const Eigen::VectorXd& amplitude) const {
  return softening_rows(amplitude, knots_) * nodal_;
}

Eigen::VectorXd InversionBasis::area() const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(nodal_.rows());
  weights(0) = knots_.front();
  for (Eigen::Index j = 0; j + 1 < nodal_.rows(); ++j) {
    const double half =
        0.5 * (knots_[static_cast<std::size_t>(j) + 1] - knots_[static_cast<std::size_t>(j)]);
    weights(j) += half;
    weights(j + 1) += half;
  }
  return nodal_.transpose() * weights;
}

Eigen::MatrixXd InversionBasis::second_differences() const {
  const double intervals = static_cast<double>(coefficients_ - 1);
  const double scale = intervals * std::sqrt(intervals);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(coefficients_ - 2, coefficients_);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    rows(i, i) = scale;
    rows(i, i + 1) = -2.0 * scale;
    rows(i, i + 2) = scale;
  }
  return rows;
}

}  // namespace microslip
