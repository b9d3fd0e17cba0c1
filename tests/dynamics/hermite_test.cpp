// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/hermite.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "microslip/algebra/core.hpp"

namespace microslip::hermite_test {
namespace {

using Eigen::Vector2d;

/// (t^7 − 3t^4 + t, 2t^5 − t²), and its derivative.
HermiteKnot knot(double t) {
  const double t3 = t * t * t;
  const Vector2d value(t3 * t3 * t - 3.0 * t3 * t + t, 2.0 * t3 * t * t - t * t);
  const Vector2d slope(7.0 * t3 * t3 - 12.0 * t3 + 1.0, 10.0 * t3 * t - 2.0 * t);
  return {t, value, slope};
}

// Four knots determine a polynomial of degree 7. All terms are below 20.
TEST(Hermite, IsThePolynomialThroughItsKnots) {
  const std::vector<HermiteKnot> knots{knot(0.0), knot(1.0), knot(-0.7), knot(1.4)};
  for (const double t : {-0.9, 0.0, 0.3, 0.5, 1.0, 1.5}) {
    EXPECT_LT((hermite_value(knots, t) - knot(t).value).norm(), 1e-13) << t;
  }
}

TEST(Hermite, IsTheTangentOfOneKnot) {
  const std::vector<HermiteKnot> knots{knot(0.5)};
  const Vector2d expected = knot(0.5).value + 0.25 * knot(0.5).slope;
  EXPECT_LT((hermite_value(knots, 0.75) - expected).norm(), 1e-15);
}

}  // namespace
}  // namespace microslip::hermite_test
