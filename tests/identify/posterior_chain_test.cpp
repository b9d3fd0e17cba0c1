// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/posterior_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/random.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/ranks.hpp"

namespace microslip::posterior_chain_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Eigen::Index kSize = 8;
constexpr Eigen::Index kRows = 120;
constexpr double kLeastLambda = 1e-2;
constexpr double kMostLambda = 1e3;

/// Data that determine some coefficients well, others poorly.
MatrixXd design() {
  MatrixXd matrix(kRows, kSize);
  for (Eigen::Index i = 0; i < kRows; ++i) {
    const double at = static_cast<double>(i) / kRows;
    for (Eigen::Index j = 0; j < kSize; ++j) {
      matrix(i, j) = std::exp(-20.0 * at * (0.1 + 0.02 * static_cast<double>(j * j)));
    }
  }
  return matrix;
}

/// A prior of which draws are simple: with L = 1 and x ≥ 0, x_j = |z_j|/√(λl_j).
ChainTarget target(const VectorXd& data) {
  ChainTarget target;
  target.rows.push_back({.design = design(), .data = data, .count = kRows});
  target.penalty = MatrixXd::Identity(kSize, kSize);
  target.limits = {kSize, VectorXd::Zero(kSize)};
  target.least_lambda = kLeastLambda;
  target.most_lambda = kMostLambda;
  return target;
}

// Ranks of λ, of single coefficients, and of their sum. The smoothness changes from node to node,
// here from coefficient to coefficient, by factors of e³, of which the product is 1. The scale of
// the scatter is 1 in truth; its own prior, which is improper, matters to O(1/rows).
TEST(PosteriorChain, HasUniformRanks) {
  MICROSLIP_OF_RELEASE_ALONE();
  constexpr int kTruths = 1000;
  constexpr std::size_t kKept = 19;  // 20 ranks
  constexpr int kThin = 3;           // neighbours are correlated
  constexpr std::size_t kBins = 20;
  std::vector<testing::RankHistogram> ranks;
  for (const char* name : {"lambda", "first", "last", "sum"})
    ranks.emplace_back(name, kKept, kBins);
  for (std::uint64_t truth = 0; truth < kTruths; ++truth) {
    RandomStream random(31, truth);
    const double lambda = kLeastLambda * std::pow(kMostLambda / kLeastLambda, random.uniform());
    VectorXd local(kSize);
    for (double& value : local) value = 3.0 * random.normal();
    local = (local.array() - local.mean()).exp().matrix();
    VectorXd x(kSize);
    for (Eigen::Index j = 0; j < kSize; ++j) {
      x(j) = std::abs(random.normal()) / std::sqrt(lambda * local(j));
    }
    VectorXd data = design() * x;
    for (double& value : data) value += random.normal();

    const ChainTarget given = target(data);
    PosteriorChain chain(given, {VectorXd::Ones(kSize), 1.0, {1.0}});
    chain.settle(random);
    std::vector<std::size_t> rank(ranks.size(), 0);
    for (std::size_t i = 0; i < kKept; ++i) {
      for (int j = 1; j < kThin; ++j) chain.next(random);
      const VectorXd& draw = chain.next(random);
      rank[0] += chain.lambda() < lambda ? 1 : 0;
      rank[1] += draw(0) < x(0) ? 1 : 0;
      rank[2] += draw(kSize - 1) < x(kSize - 1) ? 1 : 0;
      rank[3] += draw.sum() < x.sum() ? 1 : 0;
    }
    for (std::size_t k = 0; k < rank.size(); ++k) ranks[k].add(rank[k]);
  }
  for (const testing::RankHistogram& one : ranks) {
    EXPECT_GT(one.uniformity(), 0.01) << one.name();
    test::record_smallest("uniform ranks, p [1]", one.uniformity());
  }
}

double mean_scale(const ChainTarget& given) {
  RandomStream random(33, 0);
  PosteriorChain chain(given, {VectorXd::Ones(kSize), 1.0, {1.0}});
  chain.settle(random);
  double mean = 0.0;
  for (int i = 0; i < 500; ++i) {
    chain.next(random);
    mean += chain.scale() / 500.0;
  }
  return mean;
}

// 112 degrees of freedom are good to 1/√224 = 7 %; three of these.
TEST(PosteriorChain, FindsTheScaleOfTheScatter) {
  RandomStream random(32, 0);
  VectorXd data = design() * VectorXd::Constant(kSize, 20.0);
  constexpr double kTruth = 3.0;
  for (double& value : data) value += kTruth * random.normal();
  ChainTarget given = target(data);
  EXPECT_NEAR(mean_scale(given), kTruth, 0.2 * kTruth);
  given.rows.front().least_scale = 8.0;
  EXPECT_GE(mean_scale(given), 8.0);
}

// Two coefficients that data know to 1e-6 in sum, of which the prior would let the difference be 1:
// between their limits there is room for 1e-6 of a standard deviation. Their mean is half the sum,
// by symmetry; uniform between 0 and the sum, one of them is good to 1/√(12·500) of it; four times
// that.
TEST(PosteriorChain, GoesOnBetweenNarrowLimits) {
  ChainTarget narrow;
  constexpr double kSum = 1e-6;
  narrow.rows.push_back({.design = MatrixXd::Constant(1, 2, 1e8),
                         .data = VectorXd::Constant(1, 1e8 * kSum),
                         .count = 1e4,
                         .least_scale = 1.0});
  narrow.penalty = MatrixXd::Identity(2, 2);
  narrow.limits = {2, VectorXd::Zero(2)};
  narrow.least_lambda = narrow.most_lambda = 1.0;
  RandomStream random(34, 0);
  PosteriorChain chain(narrow, {VectorXd::Constant(2, 0.5 * kSum), 1.0, {1.0}});
  chain.settle(random);
  double mean = 0.0;
  for (int i = 0; i < 500; ++i) mean += chain.next(random)(0) / 500.0;
  EXPECT_NEAR(mean, 0.5 * kSum, 0.1 * kSum);
}

// Three coefficients, independent with a deviation of 1/√2: of N(−½, ½), N(0, ½) and N(1½, ½) as
// much lies at 0 as they have below it. 20 000 draws are good to 0.004; four times that.
TEST(PosteriorChain, BringsDrawsWithinLimits) {
  ChainTarget given;
  given.rows.push_back({.design = MatrixXd::Identity(3, 3),
                        .data = VectorXd{{-1.0, 0.0, 3.0}},
                        .count = 3.0,
                        .scale_known = true});
  given.penalty = MatrixXd::Identity(3, 3);
  given.limits = {3, VectorXd::Zero(3)};
  given.least_lambda = given.most_lambda = 1.0;
  RandomStream random(35, 0);
  PosteriorChain chain(given, {VectorXd::Ones(3), 1.0, {1.0}});
  constexpr int kDraws = 20000;
  VectorXd at_limit = VectorXd::Zero(3);
  double mean = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const QuadraticProgram::Solution drawn = chain.projected(random);
    ASSERT_TRUE(drawn.optimal());
    ASSERT_GE(drawn.x.minCoeff(), 0.0);
    at_limit += (drawn.x.array() == 0.0).cast<double>().matrix() / kDraws;
    mean += drawn.x(1) / kDraws;
  }
  const auto below = [](double place) { return 0.5 * std::erfc(place); };
  EXPECT_NEAR(at_limit(0), below(-0.5), 0.015);
  EXPECT_NEAR(at_limit(1), below(0.0), 0.015);
  EXPECT_NEAR(at_limit(2), below(1.5), 0.015);
  EXPECT_NEAR(mean, 0.5 / std::sqrt(std::numbers::pi), 0.015);  // E max(0, z)
}

}  // namespace
}  // namespace microslip::posterior_chain_test
