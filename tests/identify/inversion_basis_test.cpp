// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_basis.hpp"
#include "microslip/observe/level_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/joint/secant.hpp"
#include "support/quadrature.hpp"

namespace microslip::inversion_basis_test {
namespace {

constexpr double kStiffness = 2.5e5;  // N/m
constexpr double kLargest = 4e-5;     // A_max, m

Eigen::VectorXd random_theta(Eigen::Index size, std::uint64_t seed) {
  RandomStream random(seed, 0);
  Eigen::VectorXd theta(size);
  for (double& value : theta) value = 2.0 * random.uniform();
  return theta;
}

/// From below the first knot up to 1.
Eigen::VectorXd amplitudes(double lowest) {
  std::vector<double> a{0.02 * lowest, lowest, 0.3, 0.500001, 0.75, 0.999, 1.0};
  std::ranges::sort(a);
  return Eigen::Map<const Eigen::VectorXd>(a.data(), static_cast<Eigen::Index>(a.size()));
}

/// p(t) by its definition: linear between knots, constant below the first, 0 beyond the last.
long double density(const InversionBasis& basis, const Eigen::VectorXd& nodal, long double t) {
  const std::vector<double>& s = basis.knots();
  if (t <= s.front()) return nodal(0);
  if (t > s.back()) return 0.0L;
  std::size_t i = 1;
  while (i + 1 < s.size() && s[i] < t) ++i;
  const auto row = static_cast<Eigen::Index>(i);
  const long double share = (t - s[i - 1]) / (static_cast<long double>(s[i]) - s[i - 1]);
  return nodal(row - 1) + share * (static_cast<long double>(nodal(row)) - nodal(row - 1));
}

struct Case {
  double lowest;
  double top;
  double exponent;
  int coefficients;
  std::vector<BasisEdge> edges = {};

  [[nodiscard]] InversionBasis basis() const {
    return {lowest, top, exponent, coefficients, edges};
  }
};

const std::vector<Case> kCases{
    {0.0071, 1.0, 0.0, 56}, {0.0071, 1.0, -0.5, 56},
    {1e-4, 1.0, -0.9, 30},  {0.2, 0.6, -0.3, 12},
    {0.9, 1.0, 0.0, 10},    {0.0071, 1.0, -0.5, 30, {{10, 10.3}, {20, 19.6}}},
};

// K against tanh-sinh quadrature in long double of the definition (7). Both are sums of positive
// terms: the error is a few rounding errors of the result.
TEST(InversionBasis, DissipationIsTheIntegral) {
  for (const Case& c : kCases) {
    const InversionBasis basis = c.basis();
    const Eigen::VectorXd theta = random_theta(basis.size(), 1);
    const Eigen::VectorXd nodal = basis.nodal() * theta;
    const Eigen::VectorXd a = amplitudes(c.lowest);
    const Eigen::VectorXd d = basis.dissipation(a) * theta;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const long double exact = testing::integrate(
          [&](long double t) { return 4.0L * t * (a(i) - t) * density(basis, nodal, t); }, 0.0L,
          std::min(a(i), c.top), basis.knots());
      EXPECT_NEAR(d(i), static_cast<double>(exact), 1e-13 * static_cast<double>(exact))
          << "a = " << a(i);
    }
  }
}

// 1 − k_eq/k of an element that slips at share y of the amplitude, integrated in the same manner.
// The library takes differences of antiderivatives, which cancel in narrow cells: 1e−12 of the
// largest possible value, the area, is required.
TEST(InversionBasis, SofteningIsTheIntegral) {
  for (const Case& c : kCases) {
    const InversionBasis basis = c.basis();
    const Eigen::VectorXd theta = random_theta(basis.size(), 2);
    const Eigen::VectorXd nodal = basis.nodal() * theta;
    const Eigen::VectorXd a = amplitudes(c.lowest);
    const Eigen::VectorXd softening = basis.softening(a) * theta;
    const double area = basis.area().dot(theta);
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const long double exact = testing::integrate(
          [&](long double t) {
            const long double angle = std::acos(1.0L - 2.0L * t / a(i));
            const long double kept =
                (angle - 0.5L * std::sin(2.0L * angle)) / std::numbers::pi_v<long double>;
            return (1.0L - kept) * density(basis, nodal, t);
          },
          0.0L, std::min(a(i), c.top), basis.knots());
      EXPECT_NEAR(softening(i), static_cast<double>(exact), 1e-12 * area) << "a = " << a(i);
    }
  }
}

// The density of the basis is one that a Joint can have without loss, so D and k_eq of that joint,
// computed by the closed forms of joint/, must be those of the basis. 1e−12: rounding, and for k_eq
// that of k itself.
TEST(InversionBasis, IsTheDensityOfAJoint) {
  for (const Case& c : kCases) {
    const InversionBasis basis = c.basis();
    for (const bool constant : {true, false}) {
      Eigen::VectorXd theta = random_theta(basis.size(), 3);
      if (constant) theta.setOnes();
      theta *= 0.95 / basis.area().dot(theta);
      const Eigen::VectorXd nodal = basis.nodal() * theta;
      const double force = kStiffness * kLargest;
      PiecewiseLinearPart part{{0.0}, {nodal(0) / force}};
      for (Eigen::Index j = 0; j < nodal.size(); ++j) {
        part.slip_force.push_back(force * basis.knots()[static_cast<std::size_t>(j)]);
        part.density.push_back(nodal(j) / force);
      }
      const Joint joint(kStiffness, SlipDensity({part}));
      EXPECT_NEAR(joint.density().total().zeroth, 0.95, 1e-13);
      const Eigen::VectorXd a = amplitudes(c.lowest);
      const Eigen::VectorXd d = force * kLargest * (basis.dissipation(a) * theta);
      const Eigen::VectorXd softening = basis.softening(a) * theta;
      for (Eigen::Index i = 0; i < a.size(); ++i) {
        const double expected = dissipation(joint, kLargest * a(i));
        EXPECT_NEAR(d(i), expected, 1e-12 * expected);
        EXPECT_NEAR(kStiffness * (1.0 - softening(i)), secant_stiffness(joint, kLargest * a(i)),
                    1e-12 * kStiffness);
      }
    }
  }
}

TEST(InversionBasis, Layout) {
  for (const Case& c : kCases) {
    const InversionBasis basis = c.basis();
    const std::vector<double>& s = basis.knots();
    EXPECT_EQ(basis.size(), c.coefficients + std::ssize(c.edges));
    EXPECT_TRUE(std::ranges::is_sorted(s, std::less_equal<>())) << "strictly rising";
    EXPECT_EQ(s.back(), c.top);
    EXPECT_GT(s.front(), 0.0);
    EXPECT_LT(s[3], c.lowest);  // the first coefficient's knots are below the data
    // θ = 1 is the power law at the knots; the first four move together.
    const Eigen::VectorXd nodal = basis.nodal() * Eigen::VectorXd::Ones(basis.size());
    for (std::size_t j = 0; j < s.size(); ++j) {
      EXPECT_NEAR(nodal(static_cast<Eigen::Index>(j)), std::pow(s[j], c.exponent),
                  1e-14 * std::pow(s[j], c.exponent));
    }
    EXPECT_EQ((basis.nodal().col(0).array() > 0.0).count(), 4);
  }
}

// Constants and straight lines cost nothing (to rounding of the scale); ‖Lθ‖² of θ = v² on [0, 1]
// is ∫(θ″)² dv = 4 but for the two ends that have no second difference.
TEST(InversionBasis, PenaltyIsTheIntegralOfTheSquaredCurvature) {
  const InversionBasis basis(0.01, 1.0, 0.0, 41);
  const Eigen::MatrixXd rows = basis.second_differences();
  ASSERT_EQ(rows.rows(), 39);
  ASSERT_EQ(rows.cols(), 41);
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(41, 0.0, 1.0);
  EXPECT_LT((rows * Eigen::VectorXd::Ones(41)).norm(), 1e-12);
  EXPECT_LT((rows * v).norm(), 1e-11);
  EXPECT_NEAR((rows * v.cwiseAbs2()).squaredNorm(), 4.0 * 39.0 / 40.0, 1e-10);
}

// Between two edges a straight line costs nothing, and nor does a jump from one to the next; what
// bends costs as without edges.
TEST(InversionBasis, EdgesCostNothing) {
  const InversionBasis basis(0.01, 1.0, 0.0, 41, {{15, 15.25}});
  ASSERT_EQ(basis.ranges(), 2);
  ASSERT_EQ(basis.edges().size(), 1U);
  const Eigen::MatrixXd rows = basis.second_differences();
  ASSERT_EQ(rows.rows(), basis.size() - 4);
  Eigen::VectorXd v(basis.size());  // 0 to 1 over the coordinate of the knots
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const double at = i < 15 ? static_cast<double>(i) : i < 17 ? 15.25 : static_cast<double>(i - 1);
    v(i) = at / 40.0;
  }
  Eigen::VectorXd jumps = 3.0 - v.array();
  jumps.tail(basis.size() - 16) = 1.0 + 2.0 * v.tail(basis.size() - 16).array();
  EXPECT_LT((rows * jumps).norm(), 1e-10);
  // (θ″)² = 4 over all but half a spacing at each end of both ranges.
  EXPECT_NEAR((rows * v.cwiseAbs2()).squaredNorm(), 4.0 * (40.0 - 0.5 - 0.5 - 0.625 - 0.375) / 40.0,
              1e-9);
  // θ of the edge stands twice, at places 1e−6 apart.
  const auto edge = std::ranges::adjacent_find(basis.knots(),
                                               [](double a, double b) { return b - a < 2e-6 * a; });
  ASSERT_NE(edge, basis.knots().end());
  EXPECT_DOUBLE_EQ(*edge, basis.edges().front());
}

// One slider: D = 4s(a − s), k_eq by its closed form; nothing below slip.
TEST(InversionBasis, Atom) {
  const Joint joint(kStiffness, SlipDensity({AtomsPart{{kStiffness * kLargest * 0.4}, {1.0}}}));
  const Eigen::VectorXd a = amplitudes(0.1);
  const Eigen::VectorXd d = atom_dissipation(a, 0.4);
  const Eigen::VectorXd softening = atom_softening(a, 0.4);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(d(i) * kStiffness * kLargest * kLargest, dissipation(joint, kLargest * a(i)),
                1e-13 * kStiffness * kLargest * kLargest);
    EXPECT_NEAR(kStiffness * (1.0 - softening(i)), secant_stiffness(joint, kLargest * a(i)),
                1e-12 * kStiffness);
  }
  EXPECT_EQ(d(0), 0.0);
  EXPECT_EQ(softening(0), 0.0);
}

}  // namespace
}  // namespace microslip::inversion_basis_test
