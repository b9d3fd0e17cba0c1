// SPDX-License-Identifier: MIT
#include "microslip/dynamics/decoupled_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdint>

#include "microslip/base/random.hpp"

namespace microslip::decoupled_factors_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kSize = 40;

/// Unknown i couples with those of i's remainder by `groups` alone, there with one in three.
MatrixXd random_matrix(std::uint64_t seed, Index groups) {
  RandomStream random(seed, 0);
  MatrixXd matrix = MatrixXd::Zero(kSize, kSize);
  for (Index i = 0; i < kSize; ++i) {
    for (Index j = 0; j < kSize; ++j) {
      const bool coupled = i % groups == j % groups && (random.uniform() < 0.3 || i == j);
      if (coupled) matrix(i, j) = 2.0 * random.uniform() - 1.0;
    }
  }
  return matrix;
}

VectorXd random_vector(std::uint64_t seed) {
  RandomStream random(seed, 1);
  VectorXd vector(kSize);
  for (double& value : vector) value = 2.0 * random.uniform() - 1.0;
  return vector;
}

// 1e-9: the condition of such a random matrix is up to 1e4 or so, times some ten ε and a margin.
TEST(DecoupledFactors, SolveAsTheWholeMatrixDoes) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Index groups = 1 + static_cast<Index>(seed % 3);
    const MatrixXd matrix = random_matrix(seed, groups);
    const VectorXd right = random_vector(seed);
    DecoupledFactors factors;
    factors.compute(matrix);
    EXPECT_EQ(factors.groups(), static_cast<std::size_t>(groups));
    const VectorXd expected = matrix.partialPivLu().solve(right);
    EXPECT_LT((factors.solve(right) - expected).norm(), 1e-9 * expected.norm()) << seed;
  }
}

TEST(DecoupledFactors, LeaveGroupsWithoutARightSideAtRest) {
  MatrixXd matrix = random_matrix(1, 2);
  for (Index i = 0; i < kSize; i += 2) matrix.row(i).setZero();  // singular, and not asked for
  for (Index i = 0; i < kSize; i += 2) matrix.col(i).setZero();
  VectorXd right = random_vector(1);
  for (Index i = 0; i < kSize; i += 2) right[i] = 0.0;
  DecoupledFactors factors;
  factors.compute(matrix);
  const VectorXd found = factors.solve(right);
  EXPECT_LT((matrix * found - right).norm(), 1e-9);
  for (Index i = 0; i < kSize; i += 2) EXPECT_EQ(found[i], 0.0);
}

TEST(DecoupledFactors, KnowTheSignOfTheLastGroup) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const MatrixXd matrix = random_matrix(seed, 2);
    MatrixXd last(kSize / 2, kSize / 2);
    for (Index i = 0; i < kSize / 2; ++i) {
      for (Index j = 0; j < kSize / 2; ++j) last(i, j) = matrix(2 * i + 1, 2 * j + 1);
    }
    DecoupledFactors factors;
    factors.compute(matrix);
    EXPECT_EQ(factors.last_determinant_sign(), last.determinant() > 0.0 ? 1 : -1) << seed;
  }
}

}  // namespace
}  // namespace microslip::decoupled_factors_test
