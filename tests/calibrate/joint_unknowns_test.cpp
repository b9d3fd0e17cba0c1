// SPDX-License-Identifier: MIT
#include "microslip/calibrate/joint_unknowns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip::joint_unknowns_test {
namespace {

Eigen::VectorXd some_coefficients(const JointUnknowns& unknowns) {
  Eigen::VectorXd x(unknowns.size());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x(i) = 1.0 + 0.5 * std::sin(0.7 * static_cast<double>(i));
  x(x.size() - 1) = 0.3;
  return x;
}

// The rows are quadratures of the same density whose closed forms the joint has: they agree to the
// accuracy of those (Gauss points of the secant kernel: some 1e-10) .
TEST(JointUnknowns, RowsAreThoseOfTheJoint) {
  for (const double exponent : {0.0, -0.5}) {
    const JointUnknowns unknowns(7e5, 2e-4, 0.01, exponent, 30);
    const Eigen::VectorXd x = some_coefficients(unknowns);
    const Joint joint = unknowns.joint(x, false);
    EXPECT_NEAR(joint.stiffness(), 7e5 * unknowns.stiffness_row().dot(x), 1e-9 * 7e5);
    for (const double a : {2e-6, 3.1e-5, 1.7e-4, 2e-4, 2.6e-4}) {
      const double d = dissipation(joint, a);
      EXPECT_NEAR(unknowns.dissipation_row(a).dot(x), d, 1e-9 * d) << exponent << " " << a;
      const double k = secant_stiffness(joint, a);
      EXPECT_NEAR(unknowns.secant_row(a).dot(x), k, 1e-7 * k) << exponent << " " << a;
    }
  }
}

TEST(JointUnknowns, AKnownStiffnessIsKept) {
  const JointUnknowns unknowns(7e5, 2e-4, 0.01, -0.25, 30);
  const Eigen::VectorXd x = 1.001 * some_coefficients(unknowns);
  EXPECT_EQ(unknowns.joint(x, true).stiffness(), 7e5);
  EXPECT_EQ(unknowns.joint(unknowns.stuck(), true).density().total().zeroth, 0.0);
}

// By knots a density of any exponent of the same range is represented, to rounding.
TEST(JointUnknowns, KnotsTellDensitiesOfAnyExponent) {
  const JointUnknowns law(7e5, 2e-4, 0.01, -0.5, 30);
  const JointUnknowns common = law.by_knots();
  EXPECT_EQ(common.slip_displacement(), law.slip_displacement());
  for (const double exponent : {0.0, -0.25, -0.5}) {
    const JointUnknowns own(7e5, 2e-4, 0.01, exponent, 30);
    const Eigen::VectorXd x = some_coefficients(own);
    const Eigen::VectorXd y = common.projected(own, x);
    EXPECT_NEAR(common.stiffness_row().dot(y), own.stiffness_row().dot(x), 1e-12);
    for (const double a : {2e-6, 3.1e-5, 2e-4}) {
      const double d = own.dissipation_row(a).dot(x);
      EXPECT_NEAR(common.dissipation_row(a).dot(y), d, 1e-9 * d) << exponent << " " << a;
    }
  }
}

// Two knots at each edge, the density on either side free; one beside the top has no room.
TEST(JointUnknowns, JumpAtTheirEdges) {
  const std::vector<double> edges{3e-5, 9e-5};
  for (const double exponent : {0.0, -0.5}) {
    const JointUnknowns unknowns(7e5, 2e-4, 0.01, exponent, 30, {3e-5, 9e-5, 1.999e-4});
    ASSERT_EQ(unknowns.edges().size(), 2U);
    ASSERT_EQ(unknowns.ranges().size(), 3U);
    EXPECT_EQ(unknowns.penalty().rows(), unknowns.size() - 1 - 2 * 3);
    EXPECT_EQ(unknowns.middles().size(), unknowns.penalty().rows());
    const Eigen::VectorXd x = some_coefficients(unknowns);
    const Joint joint = unknowns.joint(x, false);
    for (std::size_t e = 0; e < 2; ++e) {
      EXPECT_NEAR(unknowns.edges()[e], edges[e], 1e-12 * edges[e]);
      const double f = joint.stiffness() * edges[e];
      const double jump = joint.density().density(f * (1.0 + 1e-5)) - joint.density().density(f);
      EXPECT_GT(std::abs(jump), 0.02 * joint.density().density(f)) << exponent << " " << e;
    }
    for (const double a : {2e-6, 3.1e-5, 1.7e-4, 2e-4}) {
      const double d = dissipation(joint, a);
      EXPECT_NEAR(unknowns.dissipation_row(a).dot(x), d, 1e-9 * d) << exponent << " " << a;
      const double k = secant_stiffness(joint, a);
      EXPECT_NEAR(unknowns.secant_row(a).dot(x), k, 1e-7 * k) << exponent << " " << a;
    }
  }
}

// Knots with all edges represent densities whose edges are at any of those places. Coefficients of
// a power law lie on straight lines between a quarter of the knots: beside an edge they are other
// ones, where it is off by some 1e-4.
TEST(JointUnknowns, KnotsTellDensitiesWithEdgesElsewhere) {
  for (const double exponent : {0.0, -0.25}) {
    const JointUnknowns smooth(7e5, 2e-4, 0.01, exponent, 30);
    const JointUnknowns common = smooth.by_knots({3e-5, 3.3e-5, 3.3e-5, 9e-5});
    const double accuracy = exponent == 0.0 ? 1e-9 : 1e-3;
    for (const std::vector<double>& edges :
         {std::vector{3e-5}, std::vector{3.3e-5, 9e-5}, std::vector<double>{}}) {
      const JointUnknowns own(7e5, 2e-4, 0.01, exponent, 30, edges);
      const Eigen::VectorXd x = some_coefficients(own);
      const Eigen::VectorXd y = common.projected(own, x);
      EXPECT_NEAR(common.stiffness_row().dot(y), own.stiffness_row().dot(x), 1e-12);
      for (const double a : {2e-6, 3.1e-5, 5e-5, 2e-4}) {
        const double d = own.dissipation_row(a).dot(x);
        EXPECT_NEAR(common.dissipation_row(a).dot(y), d, accuracy * d) << exponent << " " << a;
      }
    }
  }
}

// A density of other knots is interpolated at the new ones; its stiffness is kept.
// On a wider range the density goes on as it ends, which may be more than k: the joint keeps that,
// to rounding.
TEST(JointUnknowns, ProjectionKeepsTheStiffness) {
  const JointUnknowns narrow(7e5, 2e-4, 0.01, 0.0, 30);
  Eigen::VectorXd x = some_coefficients(narrow);
  x(x.size() - 1) = 0.0;
  x *= 1.0 / narrow.stiffness_row().dot(x);
  for (const double wider : {1.0, 1.3, 1.9}) {
    const JointUnknowns wide(7e5, wider * 2e-4, 0.01, 0.0, 30);
    const Eigen::VectorXd y = wide.projected(narrow, x);
    EXPECT_NEAR(wide.stiffness_row().dot(y), 1.0, 1e-12) << wider;
    EXPECT_GE(y.minCoeff(), 0.0) << wider;
  }
}

TEST(JointUnknowns, ProjectionFollowsTheDensity) {
  const JointUnknowns old(7e5, 2e-4, 0.01, 0.0, 60);
  const JointUnknowns now(7e5, 1.5e-4, 0.02, -0.5, 60);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(old.size());
  const Eigen::VectorXd y = now.projected(old, x);
  EXPECT_NEAR(now.stiffness_row().dot(y), old.stiffness_row().dot(x), 1e-12);
  const Joint before = old.joint(x, false);
  const Joint after = now.joint(y, false);
  for (const double at : {0.2, 0.5, 0.9}) {
    const double f = at * 1.5e-4 * after.stiffness();
    // Straight between 60 knots of a power law.
    EXPECT_NEAR(after.density().density(f), before.density().density(f),
                2e-3 * before.density().density(f));
  }
}

}  // namespace
}  // namespace microslip::joint_unknowns_test
