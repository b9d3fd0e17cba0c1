// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/bordered_factors.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/figures.hpp"
#include "support/structures.hpp"

/// @file Where there are many unknowns the factors of a step of Newton's method serve the next
///     ones.

namespace microslip::newton_test {
namespace {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr std::size_t kHarmonics = 9;
constexpr NewtonOptions kOptions{1e-12, 40};
// Both end where residuals are below 1e-12 or down to rounding; a resonance of a damping ratio of
// 1 % makes a hundred times that of z.
constexpr double kSame = 1e-9;

/// Twelve modes and ten joints of four kinds: 100 unknowns in odd harmonics, ω and A.
JointedStructure ten_joints(std::uint64_t seed) {
  RandomStream random(seed, 21);
  const auto shape = [&random] {
    std::vector<double> values(12);
    for (double& value : values) value = 0.3 * (2.0 * random.uniform() - 1.0);
    return values;
  };
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < 12; ++i) modes.push_back({1.0 + 0.8 * static_cast<double>(i), 0.02});
  std::vector<StructuralJoint> joints;
  const std::vector<Joint> kinds = testing::joints_of_each_kind();
  for (std::size_t j = 0; j < 10; ++j) {
    joints.push_back(
        {.name = "joint " + std::to_string(j), .joint = kinds[j % 4], .shape = shape()});
  }
  return {ModalModel(modes, {{"a", shape()}}), std::move(joints), {{"a"}}};
}

/// The solution by new factors at each step, whole steps.
int full_newton(BalanceEquations& equations, const Target& first, const Target& second,
                VectorXd& z) {
  const Index n = equations.balance_count();
  for (int step = 0; step < 30; ++step) {
    equations.evaluate(z);
    const VectorXd scale = equations.scale();
    VectorXd residual(n + 2);
    residual.head(n) = equations.residual().cwiseQuotient(scale.head(n));
    residual.tail(2) << equations.miss(first), equations.miss(second);
    if (residual.cwiseAbs().maxCoeff() <= kOptions.tolerance) return step;
    BorderedFactors factors;
    factors.compute(equations, scale, equations.miss_gradient(first) * scale.asDiagonal(),
                    equations.miss_gradient(second) * scale.asDiagonal());
    z -= scale.cwiseProduct(factors.solve(residual));
  }
  return -1;
}

struct Start {
  BalanceEquations equations;
  VectorXd z;
  double frequency;
};

/// A vibration near the first resonance, of a force at which the joints slip.
Start slipping(const JointedStructure& structure, double force) {
  const double frequency = 0.97 * structure.stuck_frequencies().front();
  const HarmonicBalance balance(structure, {"a"}, {.harmonics = kHarmonics});
  const VibrationResult found =
      balance.solve({Quantity::kAngularFrequency, frequency}, {Quantity::kForceAmplitude, force});
  EXPECT_TRUE(found.summary.converged()) << found.summary.full();
  Start start{BalanceEquations(structure, {"a"}, kHarmonics, 256), {}, frequency};
  start.z = start.equations.unknowns(found.vibration);
  return start;
}

TEST(NewtonWithKeptFactors, ComesToTheSolutionOfNewFactors) {
  int kept = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const JointedStructure structure = ten_joints(seed);
    Start start = slipping(structure, 0.3);
    for (const double ratio : {1.001, 1.01, 1.05}) {
      const Target frequency{Quantity::kAngularFrequency, start.frequency};
      const Target force{Quantity::kForceAmplitude, 0.3 * ratio};
      VectorXd z = start.z;
      BorderedFactors factors;
      const NewtonResult result = newton(start.equations, frequency, force, kOptions, z, factors);
      EXPECT_TRUE(result.converged) << seed << ": " << result.reason;
      EXPECT_TRUE(factors.are_costly());
      kept += result.kept;
      VectorXd expected = start.z;
      EXPECT_GT(full_newton(start.equations, frequency, force, expected), 0) << seed;
      const VectorXd scale = start.equations.scale();
      const double error = (z - expected).cwiseQuotient(scale).cwiseAbs().maxCoeff();
      EXPECT_LE(error, kSame) << "seed " << seed << ", ratio " << ratio;
      test::record_largest("solution [1]", error);
    }
  }
  EXPECT_GE(kept, 30);  // it is the way that is meant
}

// The direction of a curve by factors from beside it, refined, and by those of the place itself.
TEST(NewtonWithKeptFactors, KnowsTheTangentOfNewFactors) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const JointedStructure structure = ten_joints(seed);
    Start start = slipping(structure, 0.3);
    const Target frequency{Quantity::kAngularFrequency, start.frequency};
    VectorXd z = start.z;
    BorderedFactors near;
    ASSERT_TRUE(newton(start.equations, frequency, Target{Quantity::kForceAmplitude, 0.3003},
                       kOptions, z, near)
                    .converged);
    const Index n = start.equations.balance_count();
    const RowVectorXd kept = start.equations.miss_gradient(frequency);
    const auto tangent = near.tangent(start.equations, kept);
    ASSERT_TRUE(tangent.has_value()) << seed;
    const VectorXd scale = start.equations.scale();
    BorderedFactors here;
    here.compute(start.equations, scale, kept * scale.asDiagonal(),
                 RowVectorXd::Unit(n + 2, n + 1));
    const VectorXd expected = here.solve(VectorXd::Unit(n + 2, n + 1)).normalized();
    const VectorXd found = tangent->direction.cwiseQuotient(scale).normalized();
    EXPECT_LE((found - expected).norm(), kSame) << seed;
    EXPECT_EQ(tangent->determinant_sign, here.determinant_sign()) << seed;
  }
}

}  // namespace
}  // namespace microslip::newton_test
