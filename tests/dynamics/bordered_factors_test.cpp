// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/bordered_factors.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "support/structures.hpp"

namespace microslip::bordered_factors_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr std::size_t kHarmonics = 5;

std::vector<double> random_values(RandomStream& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = 2.0 * random.uniform() - 1.0;
  return values;
}

/// Six modes and four joints of four kinds, one with something in series.
JointedStructure structure_of(std::uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < 6; ++i)
    modes.push_back({0.5 + random.uniform() + 0.7 * static_cast<double>(i), 0.02});
  std::vector<StructuralJoint> joints;
  for (const Joint& joint : testing::joints_of_each_kind()) {
    joints.push_back({.name = "joint " + std::to_string(joints.size()),
                      .joint = joint,
                      .shape = random_values(random, 6),
                      .series_compliance = joints.empty() ? 0.1 : 0.0});
  }
  return {ModalModel(modes, {{"a", random_values(random, 6)}}), std::move(joints), {{"a"}}};
}

/// Random motion in odd harmonics alone.
VectorXd odd_motion(std::uint64_t seed, Index size) {
  RandomStream random(seed, 1);
  VectorXd z(size);
  for (Index i = 0; i < size; ++i) {
    const bool even = is_even_coefficient(i % coefficient_count(kHarmonics));
    z[i] = even ? 0.0 : 0.5 * random.normal();
  }
  z[size - 2] = 1.3;
  z[size - 1] = 0.4;
  return z;
}

RowVectorXd random_row(std::uint64_t seed, const VectorXd& z) {
  RandomStream random(seed, 2);
  RowVectorXd row(z.size());
  for (double& value : row) value = random.normal();
  for (Index i = 0; i + 2 < z.size(); ++i) row[i] = z[i] == 0.0 ? 0.0 : row[i];
  return row;
}

// Next to an odd wave, off by rounding, all unknowns are solved for; on it the odd ones alone. The
// first has a dense matrix of more unknowns: 1e-9 is its condition, some 1e4, times what the offset
// does to derivatives at kinks.
TEST(BorderedFactors, OfAnOddWaveAreThoseOfAllUnknowns) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const JointedStructure structure = structure_of(seed);
    BalanceEquations equations(structure, {"a"}, kHarmonics, 128);
    VectorXd z = odd_motion(seed, equations.unknown_count());
    const RowVectorXd first = random_row(seed, z);
    const RowVectorXd last = random_row(seed + 1000, z);
    const VectorXd right = random_row(seed + 2000, z).transpose();
    const auto solved = [&] {
      equations.evaluate(z);
      BorderedFactors factors;
      factors.compute(equations, equations.scale(), first, last);
      return std::pair{factors.solve(right), factors.determinant_sign()};
    };
    const auto [odd, sign] = solved();
    EXPECT_EQ(equations.moving().size(), 4U * 6U + 2U);
    z[0] = 1e-16;
    const auto [all, sign_of_all] = solved();
    EXPECT_EQ(equations.moving().size(), 4U * 11U + 2U);
    EXPECT_LT((odd - all).norm(), 1e-9 * all.norm()) << seed;
    EXPECT_EQ(sign, sign_of_all) << seed;
  }
}

TEST(BorderedFactors, SolveTheBorderedEquations) {
  const JointedStructure structure = structure_of(3);
  BalanceEquations equations(structure, {"a"}, kHarmonics, 128);
  VectorXd z = odd_motion(3, equations.unknown_count());
  z[0] = 0.1;
  equations.evaluate(z);
  const Index n = equations.balance_count();
  const VectorXd scale = equations.scale();
  const RowVectorXd first = random_row(1, z);
  const RowVectorXd last = random_row(2, z);
  const VectorXd right = random_row(4, z).transpose();
  MatrixXd matrix(n + 2, n + 2);
  matrix << scale.head(n).cwiseInverse().asDiagonal() * equations.jacobian() * scale.asDiagonal(),
      first, last;
  BorderedFactors factors;
  factors.compute(equations, scale, first, last);
  EXPECT_LT((matrix * factors.solve(right) - right).norm(), 1e-10 * right.norm());
  EXPECT_EQ(factors.determinant_sign(), matrix.determinant() > 0.0 ? 1 : -1);
}

// A second harmonic in the force, or a mean in the motion: nothing is left out.
TEST(BorderedFactors, KnowEvenHarmonicsThatMove) {
  const JointedStructure plain = structure_of(1);
  const JointedStructure structure(plain.linear(), {plain.joints().begin(), plain.joints().end()},
                                   {{"a", {1.0, 0.1}}});
  BalanceEquations equations(structure, {"a"}, kHarmonics, 128);
  VectorXd z = odd_motion(1, equations.unknown_count());
  equations.evaluate(z);
  EXPECT_EQ(static_cast<Index>(equations.moving().size()), z.size());
}

}  // namespace
}  // namespace microslip::bordered_factors_test
