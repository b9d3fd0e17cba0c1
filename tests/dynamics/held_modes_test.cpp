// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/held_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/algebra/lu.hpp"
#include "microslip/base/random.hpp"

namespace microslip::held_modes_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Index rows, Index columns, std::uint64_t seed) {
  RandomStream random(seed, 0);
  MatrixXd values(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = 0; i < rows; ++i) values(i, j) = 2.0 * random.uniform() - 1.0;
  }
  return values;
}

/// ω² of modes from 2 to 2000 Hz.
VectorXd stiffness_of_modes(Index count) {
  VectorXd stiffness(count);
  for (Index i = 0; i < count; ++i) {
    stiffness[i] =
        std::pow(12.0 * std::pow(1e3, static_cast<double>(i) / static_cast<double>(count - 1)), 2);
  }
  return stiffness;
}

// From springs that the modes hardly feel to such that hold all of them: the last, whose modes are
// all soft, are held as by the dense equations, whose rounding is a condition number of 1e8 long.
TEST(HeldModes, MoveAsTheDenseEquationsSay) {
  const VectorXd stiffness = stiffness_of_modes(60);
  const MatrixXd shapes = random_matrix(60, 3, 1);
  const MatrixXd loads = random_matrix(60, 4, 2);
  for (const double spring : {1e-3, 1e4, 1e8, 1e11}) {
    const VectorXd springs = VectorXd{{spring, 0.3 * spring, 2.0 * spring}};
    MatrixXd dense = shapes * springs.asDiagonal() * shapes.transpose();
    dense.diagonal() += stiffness;
    const MatrixXd truth = Eigen::PartialPivLU<MatrixXd>(dense).solve(loads);
    const MatrixXd found = held_displacements(stiffness, shapes, springs, loads);
    EXPECT_LT((found - truth).norm(), 1e-7 * truth.norm()) << spring;
    EXPECT_LT((dense * found - loads).norm(), 1e-8 * (dense.norm() * found.norm())) << spring;
  }
}

// A free body on two springs, with elastic modes of its own: by its balance of forces and moments a
// load at one of them is that spring's alone, so that it moves by P/k and the other not at all.
TEST(HeldModes, OfAFreeBodyAreHeldByItsSprings) {
  constexpr double kMass = 2.0;     // kg
  constexpr double kInertia = 0.3;  // kg m²
  constexpr double kArm = 0.4;      // m
  VectorXd stiffness = stiffness_of_modes(20);
  MatrixXd shapes = random_matrix(20, 2, 3);
  stiffness.head(2).setZero();
  shapes.row(0).setConstant(1.0 / std::sqrt(kMass));
  shapes.row(1) << kArm / std::sqrt(kInertia), -kArm / std::sqrt(kInertia);
  for (const double spring : {1.0, 1e5, 1e9}) {
    const VectorXd springs = VectorXd{{spring, 3.0 * spring}};
    const MatrixXd moved =
        shapes.transpose() * held_displacements(stiffness, shapes, springs, shapes);
    EXPECT_NEAR(moved(0, 0) * spring, 1.0, 1e-9) << spring;
    EXPECT_NEAR(moved(1, 1) * 3.0 * spring, 1.0, 1e-9) << spring;
    EXPECT_NEAR(moved(0, 1) * spring, 0.0, 1e-9) << spring;
  }
}

// One spring leaves the rotation about it free: that is 0, and the load at the spring moves it.
TEST(HeldModes, DoNotMoveWhereNothingRestrainsThem) {
  const VectorXd stiffness = VectorXd{{0.0, 0.0, 0.0, 4e4}};
  const MatrixXd shapes = MatrixXd{{0.7}, {0.4}, {0.0}, {1.0}};
  const VectorXd springs = VectorXd{{1e5}};
  const MatrixXd found = held_displacements(stiffness, shapes, springs, shapes);
  EXPECT_NEAR((shapes.transpose() * found)(0, 0), 1e-5, 1e-14);
  EXPECT_EQ(found(2, 0), 0.0);
  const MatrixXd none =
      held_displacements(VectorXd{{4.0, 0.0}}, MatrixXd(2, 0), VectorXd(0), MatrixXd{{2.0}, {3.0}});
  EXPECT_EQ(none(0, 0), 0.5);
  EXPECT_EQ(none(1, 0), 0.0);
}

}  // namespace
}  // namespace microslip::held_modes_test
