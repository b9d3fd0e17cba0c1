// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior_chain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/identify/smoothing_path.hpp"

namespace microslip::posterior_chain_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Eigen::Index kSize = 8;
constexpr Eigen::Index kRows = 120;

/// A prior of which draws are simple: with L = 1 and x ≥ 0, x_j = |z_j|/√λ. Data that tell some
/// coefficients well, others little.
SmoothingProblem problem(const MatrixXd& design, const VectorXd& data) {
  return {design, data, MatrixXd::Identity(kSize, kSize), VectorXd::Zero(kSize), 0};
}

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

/// p of the hypothesis that ranks from 0 to the last bin are equally frequent.
double uniformity(const std::vector<int>& counts) {
  double total = 0.0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  double sum = 0.0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  const boost::math::chi_squared distribution(static_cast<double>(counts.size() - 1));
  return boost::math::cdf(boost::math::complement(distribution, sum));
}

// Simulation-based calibration [Talts et al., arXiv 1804.06788]: of truths that are drawn from the
// prior, the rank among draws from the posterior of their data is uniform. Ranks of λ, of single
// coefficients, and of what they sum up to. The scale of the scatter is 1 in truth; its own prior,
// which is improper, matters to O(1/rows).
TEST(PosteriorChain, HasUniformRanks) {
  constexpr int kTruths = 1000;
  constexpr int kKept = 39;  // 40 ranks, two a bin
  constexpr int kThin = 8;   // neighbours are alike
  constexpr std::size_t kBins = 20;
  const MatrixXd matrix = design();
  const std::vector<double> ends = problem(matrix, VectorXd::Zero(kRows)).lambda_grid(2);
  const double most = std::log(ends.front());
  const double least = std::log(ends.back());
  std::array<std::vector<int>, 4> ranks;
  ranks.fill(std::vector<int>(kBins, 0));
  for (std::uint64_t truth = 0; truth < kTruths; ++truth) {
    RandomStream random(31, truth);
    const double lambda = std::exp(least + (most - least) * random.uniform());
    VectorXd x(kSize);
    for (double& value : x) value = std::abs(random.normal()) / std::sqrt(lambda);
    VectorXd data = matrix * x;
    for (double& value : data) value += random.normal();

    const SmoothingProblem given = problem(matrix, data);
    PosteriorChain chain(given, lambda, x);
    std::array<int, 4> rank{};
    for (int i = 0; i < kKept; ++i) {
      for (int j = 0; j < kThin; ++j) chain.next(random);
      const VectorXd& draw = chain.next(random);
      rank[0] += chain.lambda() < lambda ? 1 : 0;
      rank[1] += draw(0) < x(0) ? 1 : 0;
      rank[2] += draw(kSize - 1) < x(kSize - 1) ? 1 : 0;
      rank[3] += draw.sum() < x.sum() ? 1 : 0;
    }
    for (std::size_t k = 0; k < rank.size(); ++k) {
      ++ranks[k][static_cast<std::size_t>(rank[k]) * kBins / (kKept + 1)];
    }
  }
  const std::array<std::string, 4> names = {"lambda", "first", "last", "sum"};
  for (std::size_t k = 0; k < ranks.size(); ++k) {
    EXPECT_GT(uniformity(ranks[k]), 0.01) << names[k];
  }
}

TEST(PosteriorChain, FindsTheScaleOfTheScatter) {
  const MatrixXd matrix = design();
  RandomStream random(32, 0);
  VectorXd data = matrix * VectorXd::Constant(kSize, 20.0);
  constexpr double kTruth = 3.0;
  for (double& value : data) value += kTruth * random.normal();
  const SmoothingProblem given = problem(matrix, data);
  PosteriorChain chain(given, 1.0, VectorXd::Ones(kSize));
  for (int i = 0; i < 200; ++i) chain.next(random);
  double mean = 0.0;
  for (int i = 0; i < 1000; ++i) {
    chain.next(random);
    mean += chain.scale() / 1000.0;
  }
  // 112 degrees of freedom are good to 1/√224 = 7 %; three of these.
  EXPECT_NEAR(mean, kTruth, 0.2 * kTruth);
}

}  // namespace
}  // namespace microslip::posterior_chain_test
