// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <memory>

#include "microslip/algebra/core.hpp"

namespace microslip {

/// A = L D Lᵀ of a sparse symmetric matrix that need not be definite, with pivots of one or two
/// rows (multifrontal, MUMPS). Its work is in memory; one object is used by one thread at a time.
class SymmetricFactor {
 public:
  /// @param lower  A on and below the diagonal; the part above is ignored.
  /// @throws InputError  where A is singular by its pivots, or the memory too small.
  explicit SymmetricFactor(const Eigen::SparseMatrix<double>& lower);
  ~SymmetricFactor();
  SymmetricFactor(SymmetricFactor&&) noexcept;
  SymmetricFactor& operator=(SymmetricFactor&&) noexcept;

  /// x of A x = b, in place; b may have several columns.
  void solve(Eigen::Ref<Eigen::MatrixXd> right_sides) const;

  /// How many eigenvalues of A are negative (Sylvester's law of inertia).
  [[nodiscard]] std::size_t negative_eigenvalues() const;

  /// Rows of A.
  [[nodiscard]] Eigen::Index size() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace microslip
