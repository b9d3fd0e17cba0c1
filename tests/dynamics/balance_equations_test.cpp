// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/balance_equations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "support/densities.hpp"
#include "support/figures.hpp"

namespace microslip::balance_equations_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<double> random_values(RandomStream& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = 2.0 * random.uniform() - 1.0;
  return values;
}

/// Four modes, one of them of a rigid body unless it shortens, three joints with all they may have,
/// and two excitations with harmonics.
JointedStructure structure_with_three_joints(bool shortens, DampingLaw law) {
  RandomStream random(7, shortens ? 1 : 0);
  const std::vector<Mode> modes{
      {shortens ? 60.0 : 0.0, 0.01}, {250.0, 0.02}, {400.0, 0.03}, {700.0, 0.01}};
  const ModalModel linear(modes,
                          {{"a", random_values(random, 4)}, {"b", random_values(random, 4)}});
  std::vector<StructuralJoint> joints;
  for (const char* name : {"one", "two", "three"}) {
    StructuralJoint joint{.name = name,
                          .joint = testing::reference_joint(),
                          .shape = random_values(random, 4),
                          .spring_in_modes = (shortens ? 1e3 : 0.0) * random.uniform(),
                          .series_compliance = 1e-6 * random.uniform()};
    if (shortens) {
      joint.shortening.resize(16);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          joint.shortening[4 * i + j] = joint.shortening[4 * j + i] = 1e3 * random.uniform();
        }
      }
    }
    joint.linear_damping = 2e4 * static_cast<double>(joints.size());
    joints.push_back(std::move(joint));
  }
  const std::vector<Excitation> excitations{{"a", {1.0, {0.1, 0.2}}},
                                            {"b", {{0.3, -0.4}, 0.0, 0.2}}};
  return JointedStructure(linear, joints, excitations, law);
}

VectorXd random_unknowns(const BalanceEquations& equations, std::uint64_t seed) {
  RandomStream random(seed, 0);
  VectorXd z(equations.unknown_count());
  for (double& value : z) value = 1e-4 * (2.0 * random.uniform() - 1.0);
  z[z.size() - 2] = 180.0 + 100.0 * random.uniform();
  z[z.size() - 1] = 20.0;
  return z;
}

/// Central differences along each unknown, extrapolated from two steps (Richardson), once and twice
/// a share of its scale: 1e-6 leaves 1e-9 of rounding.
template <typename Value>
Eigen::MatrixXd by_differences(BalanceEquations& equations, const VectorXd& z, const Value& value,
                               double share = 1e-6) {
  equations.evaluate(z);
  const VectorXd scale = equations.scale();
  Eigen::MatrixXd result;
  for (Index j = 0; j < z.size(); ++j) {
    const auto at = [&](double step) -> VectorXd {
      VectorXd moved = z;
      moved[j] += step * scale[j];
      equations.evaluate(moved);
      return value();
    };
    const auto slope = [&](double step) -> VectorXd {
      return (at(step) - at(-step)) / (2.0 * step);
    };
    const VectorXd column = (4.0 * slope(share) - slope(2.0 * share)) / 3.0;
    result.conservativeResize(column.size(), z.size());
    result.col(j) = column;
  }
  equations.evaluate(z);
  return result;
}

/// Largest error of a column over its norm; a column of zeros must be that.
double largest_error(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
  double largest = 0.0;
  for (Index j = 0; j < found.cols(); ++j) {
    const double error = (found.col(j) - expected.col(j)).norm();
    if (error > 0.0) largest = std::max(largest, error / expected.col(j).norm());
  }
  return largest;
}

// Inner loops leave terms of the order N^-3 out of the joints' derivatives: 1e-7 with 1024 samples,
// seen through receptances times stiffness of the order 10.
TEST(BalanceEquations, HaveTheDerivativesOfDifferences) {
  for (const bool shortens : {false, true}) {
    for (const DampingLaw law : {DampingLaw::kViscous, DampingLaw::kHysteretic}) {
      const JointedStructure structure = structure_with_three_joints(shortens, law);
      BalanceEquations equations(structure, {"b", ResponseKind::kAcceleration}, 3, 1024);
      ASSERT_EQ(equations.balance_count(), 21);
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const VectorXd z = random_unknowns(equations, seed);
        const auto residual = by_differences(equations, z, [&] { return equations.residual(); });
        const VectorXd scale = equations.scale();
        const Eigen::MatrixXd jacobian = equations.jacobian() * scale.asDiagonal();
        EXPECT_LT(largest_error(jacobian, residual), 1e-6)
            << "shortens " << shortens << ", seed " << seed;
        test::record_largest("column [1]", largest_error(jacobian, residual));

        const auto response = by_differences(equations, z, [&]() -> VectorXd {
          return (VectorXd(3) << equations.log_response(), equations.response().real(),
                  equations.response().imag())
              .finished();
        });
        const Eigen::RowVectorXd logarithm = equations.log_response_gradient() * scale.asDiagonal();
        EXPECT_LT((logarithm - response.row(0)).norm(), 1e-6 * logarithm.norm());
        const Eigen::RowVectorXcd gradient = equations.response_gradient() * scale.asDiagonal();
        EXPECT_LT((gradient.real() - response.row(1)).norm(), 1e-6 * gradient.norm());
        EXPECT_LT((gradient.imag() - response.row(2)).norm(), 1e-6 * gradient.norm());
      }
    }
  }
}

// The equations that make the system square: both targets and their derivatives. Differences of
// 1e-7 leave 1e-8.
TEST(BalanceEquations, HaveTheDerivativesOfTheirTargets) {
  const JointedStructure structure = structure_with_three_joints(false, DampingLaw::kViscous);
  BalanceEquations equations(structure, {"b", ResponseKind::kVelocity}, 3, 1024);
  const VectorXd z = random_unknowns(equations, 5);
  equations.evaluate(z);
  for (const Quantity quantity : {Quantity::kAngularFrequency, Quantity::kForceAmplitude,
                                  Quantity::kResponse, Quantity::kPhaseLag}) {
    const Target target{quantity, 1.1 * std::abs(equations.value(quantity))};
    const Eigen::MatrixXd expected =
        by_differences(equations, z, [&] { return VectorXd::Constant(1, equations.miss(target)); });
    const VectorXd scale = equations.scale();
    const Eigen::RowVectorXd gradient = equations.miss_gradient(target) * scale.asDiagonal();
    EXPECT_LT((gradient - expected).cwiseAbs().maxCoeff(), 1e-6 * gradient.cwiseAbs().maxCoeff())
        << to_string(quantity);
  }
}

// Random harmonics make inner loops: pairs of maxima and of minima that may become equal.
// Differences leave 1e-8.
TEST(BalanceEquations, HaveTheDerivativesOfTheirTies) {
  const JointedStructure structure = structure_with_three_joints(false, DampingLaw::kViscous);
  BalanceEquations equations(structure, {"b"}, 3, 1024);
  const VectorXd z = random_unknowns(equations, 5);
  equations.evaluate(z);
  const std::vector<Tie> ties = equations.ties();
  ASSERT_GE(ties.size(), 2U);
  for (const Tie& tie : ties) {
    const Eigen::MatrixXd expected =
        by_differences(equations, z, [&] { return VectorXd::Constant(1, equations.miss(tie)); });
    const VectorXd scale = equations.scale();
    const Eigen::RowVectorXd gradient = equations.miss_gradient(tie) * scale.asDiagonal();
    EXPECT_LT((gradient - expected).cwiseAbs().maxCoeff(), 1e-6 * gradient.cwiseAbs().maxCoeff());
  }
}

// An undamped mode exactly at its pole, by its first or its third harmonic. Small steps: the
// equations are scaled otherwise 1e-6 away from it.
TEST(BalanceEquations, HaveTheDerivativesOfDifferencesAtAPole) {
  RandomStream random(11, 0);
  const ModalModel linear({{300.0, 0.0}, {410.0, 0.01}}, {{"a", random_values(random, 2)}});
  const StructuralJoint joint{.name = "one",
                              .joint = testing::reference_joint(),
                              .shape = {0.6, -0.4},
                              .spring_in_modes = 1e4,
                              .series_compliance = 1e-6};
  const JointedStructure structure(linear, {joint}, {{"a"}});
  for (const double omega : {300.0, 100.0}) {
    BalanceEquations equations(structure, {"a"}, 3, 1024);
    VectorXd z = random_unknowns(equations, 2);
    z[z.size() - 2] = omega;
    const auto residual = by_differences(
        equations, z, [&] { return equations.residual(); }, 5e-8);
    EXPECT_TRUE(residual.allFinite());
    const Eigen::MatrixXd jacobian = equations.jacobian() * equations.scale().asDiagonal();
    EXPECT_LT(largest_error(jacobian, residual), 1e-6);
  }
}

// A joint that shortens by nothing is one that does not: the two formulations agree to rounding.
TEST(BalanceEquations, AreTheSameInBothFormulations) {
  const JointedStructure plain = structure_with_three_joints(true, DampingLaw::kViscous);
  std::vector<StructuralJoint> none(plain.joints().begin(), plain.joints().end());
  std::vector<StructuralJoint> zero = none;
  for (auto& joint : none) joint.shortening.clear();
  for (auto& joint : zero) joint.shortening.assign(16, 0.0);
  const auto build = [&](const std::vector<StructuralJoint>& joints) {
    return JointedStructure(plain.linear(), joints,
                            {plain.excitations().begin(), plain.excitations().end()});
  };
  const JointedStructure by_receptance = build(none);
  const JointedStructure by_modes = build(zero);
  ASSERT_FALSE(by_receptance.shortens());
  ASSERT_TRUE(by_modes.shortens());
  // A solution of one is a solution of the other.
  BalanceEquations one(by_receptance, {"b"}, 3, 256);
  BalanceEquations other(by_modes, {"b"}, 3, 256);
  VectorXd z = random_unknowns(one, 3);
  const Index n = one.balance_count();
  for (int step = 0; step < 60; ++step) {
    one.evaluate(z);
    z.head(n) -= 0.5 * one.jacobian().leftCols(n).partialPivLu().solve(one.residual());
  }
  one.evaluate(z);
  ASSERT_LT(one.residual().norm(), 1e-12 * z.head(n).norm());
  other.evaluate(z);
  EXPECT_LT(other.residual().norm(), 1e-10 * z.head(n).norm());
  EXPECT_LT(std::abs(one.response() - other.response()), 1e-10 * std::abs(one.response()));
  const SteadyVibration first = one.vibration();
  const SteadyVibration second = other.vibration();
  EXPECT_LT(first.energy_imbalance, 1e-8);
  EXPECT_LT(second.energy_imbalance, 1e-8);
  EXPECT_NEAR(first.input_energy, second.input_energy, 1e-9 * first.input_energy);
}

// ---- Functions by their harmonics. ----

TEST(MultiplicationMatrix, MultipliesFunctions) {
  RandomStream random(3, 0);
  const std::vector<double> t = random_values(random, 13);  // up to harmonic 6
  const std::vector<double> y = random_values(random, 7);   // up to harmonic 3
  const VectorXd product = multiplication_matrix(Eigen::Map<const VectorXd>(t.data(), 13), 3) *
                           Eigen::Map<const VectorXd>(y.data(), 7);
  // The product has harmonics up to 9: 32 samples determine its first 3 exactly.
  const TrigonometricBasis basis(3, 32);
  VectorXd sampled(32);
  for (Index k = 0; k < 32; ++k) {
    const double tau = 2.0 * 3.14159265358979323846 * static_cast<double>(k) / 32.0;
    sampled[k] = motion_at(t, tau).value * motion_at(y, tau).value;
  }
  const VectorXd expected =
      basis.weights().asDiagonal() * basis.rows().leftCols(7).transpose() * sampled;
  EXPECT_LT((product - expected).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace microslip::balance_equations_test
