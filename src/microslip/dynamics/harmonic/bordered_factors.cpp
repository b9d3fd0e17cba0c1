// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/bordered_factors.hpp"

#include <utility>

namespace microslip {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

void BorderedFactors::compute(BalanceEquations& equations, const VectorXd& scale,
                              const RowVectorXd& first, const RowVectorXd& last) {
  moving_ = equations.moving();
  const auto size = static_cast<Index>(moving_.size());
  scale_ = scale(moving_);
  matrix_.resize(size, size);
  const Eigen::MatrixXd& jacobian = equations.jacobian();
  const VectorXd inverse = scale_.head(size - 2).cwiseInverse();
  for (Index j = 0; j < size; ++j) {
    matrix_.col(j).head(size - 2) = scale_[j] * inverse.cwiseProduct(jacobian.col(j));
  }
  matrix_.row(size - 2) = first(moving_);
  last_ = last(moving_);
  matrix_.row(size - 1) = last_;
  factors_.compute(matrix_);
}

VectorXd BorderedFactors::solve(const VectorXd& right) const {
  VectorXd found(scale_.size());
  const auto& order = factors_.permutationP().indices();
  for (Index i = 0; i < found.size(); ++i) {
    found[order[i]] = right[moving_[static_cast<std::size_t>(i)]];
  }
  factors_.matrixLU().triangularView<Eigen::UnitLower>().solveInPlace(found);
  factors_.matrixLU().triangularView<Eigen::Upper>().solveInPlace(found);
  VectorXd solution = VectorXd::Zero(right.size());
  solution(moving_) = found;
  return solution;
}

/// The determinant itself may be too large or too small for a double.
int BorderedFactors::determinant_sign() const {
  const auto pivots = factors_.matrixLU().diagonal();
  const bool odd = (pivots.array() < 0.0).count() % 2 == 1;
  const bool swapped = factors_.permutationP().determinant() < 0;
  return odd == swapped ? 1 : -1;
}

/// M x of another Jacobian and first row, relative.
VectorXd BorderedFactors::product(const Eigen::MatrixXd& jacobian, const RowVectorXd& first,
                                  const VectorXd& x) const {
  const Index n = x.size() - 2;
  VectorXd result(n + 2);
  result.head(n) = (jacobian * scale_.cwiseProduct(x)).cwiseQuotient(scale_.head(n));
  result[n] = first * x;
  result[n + 1] = last_ * x;
  return result;
}

std::optional<BorderedFactors::Tangent> BorderedFactors::tangent(BalanceEquations& equations,
                                                                 const RowVectorXd& first) const {
  constexpr int kMostRounds = 5;
  constexpr double kContraction = 1e-2;  // more is no neighbour, or lies behind a kink
  constexpr double kAccurate = 1e-13;
  if (equations.moving() != moving_) return std::nullopt;
  const RowVectorXd row = first(moving_) * scale_.asDiagonal();
  const VectorXd unit = VectorXd::Unit(scale_.size(), scale_.size() - 1);
  VectorXd x = factors_.solve(unit);
  double before = x.norm();
  for (int round = 0; round < kMostRounds; ++round) {
    const VectorXd change = factors_.solve(unit - product(equations.jacobian(), row, x));
    x += change;
    const double now = change.norm();
    if (!(now < kContraction * before)) return std::nullopt;
    if (now <= kAccurate * x.norm()) {
      VectorXd direction = VectorXd::Zero(equations.unknown_count());
      direction(moving_) = scale_.cwiseProduct(x);
      return Tangent{std::move(direction), determinant_sign()};
    }
    before = now;
  }
  return std::nullopt;
}

}  // namespace microslip
