// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/truncated_gaussian.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/base/random.hpp"

namespace microslip::truncated_gaussian_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kDraws = 200'000;

/// Means of the draws and of their squares. A trajectory of a quarter period forgets where it was
/// but for the effect of the limits: 200 000 draws are good to some 1/√100 000 = 0.3 % of a
/// deviation; bounds of 1.2 % are four of these.
struct Moments {
  VectorXd mean;
  MatrixXd second;
};

Moments moments(const MatrixXd& hessian, const VectorXd& linear, const VectorXd& budget, VectorXd x,
                std::uint64_t seed) {
  const Eigen::Index size = linear.size();
  TruncatedGaussian gaussian({size, budget});
  gaussian.set(hessian, linear);
  RandomStream random(seed, 0);
  Moments found{VectorXd::Zero(size), MatrixXd::Zero(size, size)};
  for (int i = 0; i < 100; ++i) gaussian.move(x, random);
  for (int i = 0; i < kDraws; ++i) {
    gaussian.move(x, random);
    found.mean += x / kDraws;
    found.second += x * x.transpose() / kDraws;
  }
  return found;
}

constexpr double kBound = 0.012;

TEST(TruncatedGaussian, OfOneSideHasTheMomentsOfTheHalfNormal) {
  MatrixXd hessian = MatrixXd::Identity(1, 1) * 4.0;  // deviation 1/2
  const Moments found =
      moments(hessian, VectorXd::Zero(1), VectorXd::Zero(1), VectorXd::Zero(1), 1);
  EXPECT_NEAR(found.mean(0), 0.5 * std::sqrt(2.0 / std::numbers::pi), 0.5 * kBound);
  EXPECT_NEAR(found.second(0, 0), 0.25, 0.25 * 2.0 * kBound);
}

// E[x] = μ + σ ϕ(α)/(1 − Φ(α)), α = −μ/σ: for μ = −2, σ = 1 it is −2 + ϕ(2)/Φ(−2).
TEST(TruncatedGaussian, FarFromItsMeanHasTheMomentsOfTheTail) {
  const double density = std::exp(-2.0) / std::sqrt(2.0 * std::numbers::pi);
  const double beyond = 0.5 * std::erfc(2.0 / std::numbers::sqrt2);
  const Moments found = moments(MatrixXd::Identity(1, 1), VectorXd::Constant(1, -2.0),
                                VectorXd::Zero(1), VectorXd::Zero(1), 2);
  EXPECT_NEAR(found.mean(0), -2.0 + density / beyond, 0.4 * kBound);
}

// E[x₁] = (1 + ρ)/(2√(2π)) / P with P = ¼ + asin ρ/(2π) over the positive quadrant
// [Rosenbaum, J. R. Stat. Soc. B 23 (1961) 405].
TEST(TruncatedGaussian, OfTwoAlikeHasTheMeanOfTheQuadrant) {
  for (const double rho : {-0.9, -0.5, 0.6, 0.95}) {
    MatrixXd covariance(2, 2);
    covariance << 1.0, rho, rho, 1.0;
    const MatrixXd hessian = covariance.inverse();
    const Moments found =
        moments(hessian, VectorXd::Zero(2), VectorXd::Zero(2), VectorXd::Ones(2), 3);
    const double share = 0.25 + std::asin(rho) / (2.0 * std::numbers::pi);
    const double expected = (1.0 + rho) / (2.0 * std::sqrt(2.0 * std::numbers::pi)) / share;
    EXPECT_NEAR(found.mean(0), expected, kBound) << rho;
    EXPECT_NEAR(found.mean(1), expected, kBound) << rho;
  }
}

// So wide that the budget alone limits, to 0.5 %: uniform on a triangle, of mean 1/3 and mean
// square 1/6.
TEST(TruncatedGaussian, WithinABudgetIsUniformWhereTheGaussianIsFlat) {
  const Moments found = moments(1e-2 * MatrixXd::Identity(2, 2), VectorXd::Zero(2),
                                VectorXd::Ones(2), VectorXd::Constant(2, 0.2), 4);
  for (const int i : {0, 1}) {
    EXPECT_NEAR(found.mean(i), 1.0 / 3.0, 0.01);
    EXPECT_NEAR(found.second(i, i), 1.0 / 6.0, 0.01);
  }
  EXPECT_NEAR(found.second(0, 1), 1.0 / 12.0, 0.01);
}

TEST(TruncatedGaussian, StaysWithinItsLimits) {
  constexpr Eigen::Index kSize = 30;
  RandomStream random(5, 0);
  MatrixXd factor(kSize, kSize);
  for (double& value : factor.reshaped()) value = random.normal();
  const MatrixXd hessian = factor * factor.transpose() + 1e-3 * MatrixXd::Identity(kSize, kSize);
  VectorXd linear(kSize);
  for (double& value : linear) value = 5.0 * random.normal();
  const VectorXd budget = VectorXd::Constant(kSize, 0.1);
  TruncatedGaussian chain({kSize, budget});
  chain.set(hessian, linear);
  VectorXd x = VectorXd::Constant(kSize, 0.1);
  for (int i = 0; i < 5000; ++i) {
    chain.move(x, random);
    ASSERT_GE(x.minCoeff(), 0.0);
    ASSERT_LE(budget.dot(x), 1.0 + 1e-9);
  }
}

// ∫ exp(−½xᵀHx + gᵀx) dx = (2π)^(n/2) |H|^−½ exp(½gᵀH⁻¹g): H of two numbers, g = (1, 2).
TEST(TruncatedGaussian, KnowsItsIntegralWithoutLimits) {
  TruncatedGaussian chain({2, VectorXd::Zero(2)});
  MatrixXd hessian(2, 2);
  hessian << 3.0, 1.0, 1.0, 2.0;
  VectorXd linear(2);
  linear << 1.0, 2.0;
  chain.set(hessian, linear);
  // |H| = 5, H⁻¹g = (0, 1).
  EXPECT_NEAR(chain.log_integral(), 0.5 * 2.0 - 0.5 * std::log(5.0), 1e-14);
  EXPECT_NEAR(chain.standard_deviation()(0), std::sqrt(0.4), 1e-14);
  EXPECT_NEAR(chain.standard_deviation()(1), std::sqrt(0.6), 1e-14);
}

// A coefficient without a limit beside one that has one.
TEST(TruncatedGaussian, LimitsTheFirstCoefficientsAlone) {
  TruncatedGaussian chain({1, VectorXd::Zero(2)});
  chain.set(MatrixXd::Identity(2, 2), VectorXd::Zero(2));
  RandomStream random(7, 0);
  VectorXd x = VectorXd::Ones(2);
  int negative = 0;
  for (int i = 0; i < 4000; ++i) {
    chain.move(x, random);
    ASSERT_GE(x(0), 0.0);
    negative += x(1) < 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(negative, 2000, 4 * 32);  // √4000/2 = 32
}

// Two budgets of one coefficient each cut a box out of the positive quadrant, in which a Gaussian
// that is wide is uniform: means at half of the sides. 20 000 draws determine them to 0.3 % of a
// side or so.
TEST(TruncatedGaussian, KeepsToSeveralBudgets) {
  constexpr int kOfBox = 20'000;
  MatrixXd budgets(2, 2);
  budgets << 2.0, 0.0,  //
      0.0, 4.0;
  TruncatedGaussian gaussian({2, budgets});
  gaussian.set(1e-2 * MatrixXd::Identity(2, 2), VectorXd::Zero(2));
  RandomStream random(8, 0);
  VectorXd x = VectorXd::Constant(2, 0.1);
  VectorXd mean = VectorXd::Zero(2);
  for (int i = 0; i < kOfBox; ++i) {
    gaussian.move(x, random);
    ASSERT_LE(x(0), 0.5 + 1e-9);
    ASSERT_LE(x(1), 0.25 + 1e-9);
    mean += x / kOfBox;
  }
  EXPECT_NEAR(mean(0), 0.25, kBound * 0.5);
  EXPECT_NEAR(mean(1), 0.125, kBound * 0.25);
}

TEST(TruncatedGaussian, RepeatsWithItsSeed) {
  const auto draw = [](std::uint64_t seed) {
    RandomStream random(seed, 0);
    TruncatedGaussian chain({3, VectorXd::Zero(3)});
    chain.set(MatrixXd::Identity(3, 3), VectorXd::Ones(3));
    VectorXd x = VectorXd::Ones(3);
    for (int i = 0; i < 10; ++i) chain.move(x, random);
    return x;
  };
  EXPECT_EQ(draw(6), draw(6));
  EXPECT_NE(draw(6), draw(7));
}

// A trajectory that is ended at a limit leaves x on it, and the next may go outwards from there:
// draws of few levels once had 1.5 times the area of the budget, the first of these chains 11
// times.
TEST(TruncatedGaussian, StaysWithinLimitsThatItStartsOn) {
  constexpr Eigen::Index kSize = 6;
  const VectorXd budget = VectorXd::LinSpaced(kSize, 0.3, 0.7);
  for (std::uint64_t chain = 0; chain < 400; ++chain) {
    RandomStream random(5, chain);
    VectorXd linear(kSize);
    for (double& value : linear) value = 3.0 + random.normal();  // the mean is beyond the budget
    TruncatedGaussian gaussian({kSize, budget});
    gaussian.set(MatrixXd::Identity(kSize, kSize), linear);
    VectorXd x = VectorXd::Constant(kSize, 0.1);
    for (int i = 0; i < 20; ++i) {
      gaussian.move(x, random, i % 4 == 3 ? TruncatedGaussian::kNoEnd : 1);
      ASSERT_LE(budget.dot(x), 1.0 + 1e-12) << chain << ", " << i;
    }
  }
}

}  // namespace
}  // namespace microslip::truncated_gaussian_test
