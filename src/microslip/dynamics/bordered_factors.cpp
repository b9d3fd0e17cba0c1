// SPDX-License-Identifier: MIT
#include "microslip/dynamics/bordered_factors.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

void BorderedFactors::compute(BalanceEquations& equations, const VectorXd& scale,
                              const RowVectorXd& first, const RowVectorXd& last) {
  moving_ = equations.moving();
  const auto size = static_cast<Index>(moving_.size());
  const VectorXd own = scale(moving_);
  matrix_.resize(size, size);
  matrix_.topRows(size - 2) =
      own.head(size - 2).cwiseInverse().asDiagonal() * equations.jacobian() * own.asDiagonal();
  matrix_.row(size - 2) = first(moving_);
  matrix_.row(size - 1) = last(moving_);
  factors_.compute(matrix_);
}

VectorXd BorderedFactors::solve(const VectorXd& right) const {
  const VectorXd found = factors_.solve(right(moving_));
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

}  // namespace microslip
