// SPDX-License-Identifier: MIT
#include "microslip/modes/symmetric_factor.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/algebra/lu.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "support/messages.hpp"

namespace microslip::symmetric_factor_test {
namespace {

/// Symmetric, without definite sign, a third of it filled.
Eigen::MatrixXd random_symmetric(Eigen::Index size, std::uint64_t stream) {
  RandomStream random(11, stream);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    for (Eigen::Index i = j; i < size; ++i) {
      if (i == j || random.uniform() < 0.3) matrix(i, j) = matrix(j, i) = random.normal();
    }
  }
  return matrix;
}

// Against Eigen's dense LU and eigenvalues: another algorithm and another library.
TEST(SymmetricFactor, SolvesAndCountsAsADenseSolver) {
  for (std::uint64_t stream = 0; stream < 20; ++stream) {
    const Eigen::Index size = 5 + static_cast<Eigen::Index>(stream) * 3;
    const Eigen::MatrixXd dense = random_symmetric(size, stream);
    const SymmetricFactor factor(dense.sparseView());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense);
    const auto negative = static_cast<std::size_t>((eigen.eigenvalues().array() < 0.0).count());
    EXPECT_EQ(factor.negative_eigenvalues(), negative) << stream;
    const Eigen::MatrixXd right = random_symmetric(size, 100 + stream).leftCols(3);
    Eigen::MatrixXd found = right;
    factor.solve(found);
    const double condition =
        eigen.eigenvalues().cwiseAbs().maxCoeff() / eigen.eigenvalues().cwiseAbs().minCoeff();
    // The error of either is the condition number times some roundings.
    EXPECT_LT((found - dense.partialPivLu().solve(right)).norm(),
              1e-14 * condition * static_cast<double>(size) * found.norm())
        << stream;
  }
}

TEST(SymmetricFactor, RefusesASingularMatrix) {
  Eigen::MatrixXd dense(2, 2);
  dense << 1.0, 1.0, 1.0, 1.0;
  test::expect_message(
      test::message_or("none", [&] { return SymmetricFactor(dense.sparseView()); }), "singular");
  EXPECT_THROW(SymmetricFactor(Eigen::SparseMatrix<double>(0, 0)), InputError);
  EXPECT_THROW(SymmetricFactor(Eigen::SparseMatrix<double>(2, 3)), InputError);
}

}  // namespace
}  // namespace microslip::symmetric_factor_test
