// SPDX-License-Identifier: MIT
#include "microslip/dynamics/decoupled_factors.hpp"

#include <algorithm>
#include <iterator>

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The sign of a determinant, which itself may be too large or too small for a double.
int determinant_sign(const Eigen::PartialPivLU<MatrixXd>& factors) {
  const auto pivots = factors.matrixLU().diagonal();
  const bool odd = (pivots.array() < 0.0).count() % 2 == 1;
  const bool swapped = factors.permutationP().determinant() < 0;
  return odd == swapped ? 1 : -1;
}

/// All that the unknown reaches, taken from those that are left, rising.
std::vector<Index> reached_from(Index first, const MatrixXd& matrix, std::vector<Index>& left) {
  std::vector<Index> found{first};
  std::erase(left, first);
  for (std::size_t next = 0; next < found.size() && !left.empty(); ++next) {
    const Index i = found[next];
    const auto coupled = [&](Index j) { return matrix(j, i) != 0.0 || matrix(i, j) != 0.0; };
    std::ranges::copy_if(left, std::back_inserter(found), coupled);
    std::erase_if(left, coupled);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

void DecoupledFactors::compute(const MatrixXd& matrix) {
  matrix_ = matrix;
  groups_.clear();
  std::vector<Index> left(static_cast<std::size_t>(matrix.rows()));
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<Index>(i);
  while (!left.empty()) groups_.push_back({.members = reached_from(left.back(), matrix_, left)});
}

void DecoupledFactors::factor(Group& group) const {
  if (group.factored) return;
  group.factored = true;
  const bool whole = static_cast<Index>(group.members.size()) == matrix_.rows();
  if (whole) {
    group.factors.compute(matrix_);
  } else {
    group.factors.compute(matrix_(group.members, group.members));
  }
}

VectorXd DecoupledFactors::solve(const VectorXd& right) {
  VectorXd solution = VectorXd::Zero(right.size());
  for (Group& group : groups_) {
    const VectorXd own = right(group.members);
    if (own.isZero(0.0)) continue;
    factor(group);
    const VectorXd found = group.factors.solve(own);
    solution(group.members) = found;
  }
  return solution;
}

int DecoupledFactors::last_determinant_sign() {
  factor(groups_.front());
  return determinant_sign(groups_.front().factors);
}

}  // namespace microslip
