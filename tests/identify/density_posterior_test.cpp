// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/density_posterior.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "support/densities.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/ranks.hpp"

namespace microslip::density_posterior_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::kStiffness;

MatrixXd matrix_of(const PlainMatrix& plain) {
  MatrixXd matrix(plain.rows(), plain.columns);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      matrix(i, j) = plain.values[static_cast<std::size_t>(i * matrix.cols() + j)];
    }
  }
  return matrix;
}

/// 90 levels of which each D is known to 1 %, on so few coefficients that random densities are
/// found.
DensityPosterior small_posterior() {
  Levels levels = testing::noisy_levels(testing::reference_joint(), 3);
  for (const double d : levels.dissipation) levels.dissipation_std.push_back(0.01 * d);
  InversionOptions options;
  options.coefficients = 12;
  options.edges = false;  // truths are drawn from a prior without
  return invert(levels, kStiffness, options).posterior;
}

/// Draws truths from the prior of a posterior without any chain: those within the limits of
/// Gaussian second differences, and of two coefficients that lie anywhere between the limits.
class PriorTruths {
 public:
  explicit PriorTruths(const DensityPosterior& posterior)
      : smoothing_(posterior.smoothing),
        area_(Eigen::Map<const VectorXd>(posterior.area.data(),
                                         static_cast<Eigen::Index>(posterior.area.size()))) {
    const MatrixXd penalty = matrix_of(posterior.penalty);
    const Eigen::Index n = penalty.cols();
    MatrixXd all = MatrixXd::Zero(n, n);
    all.topRows(n - 2) = penalty;
    all(n - 2, kFirst) = 1.0;
    all(n - 1, kSecond) = 1.0;
    solver_.compute(all);
  }

  VectorXd draw(RandomStream& random) const {
    const Eigen::Index n = area_.size();
    while (true) {
      const double lambda =
          smoothing_.least * std::pow(smoothing_.most / smoothing_.least, random.uniform());
      VectorXd local(n - 2);  // one node per row
      for (double& value : local) value = 3.0 * random.normal();
      local = (local.array() - local.mean()).exp().matrix();
      VectorXd right(n);
      for (Eigen::Index i = 0; i < n - 2; ++i) {
        right(i) = random.normal() / std::sqrt(lambda * local(i));
      }
      right(n - 2) = random.uniform() / area_(kFirst);
      right(n - 1) = random.uniform() / area_(kSecond);
      VectorXd x = solver_.solve(right);
      if (x.minCoeff() >= 0.0 && area_.dot(x) <= 1.0) return x;
    }
  }

 private:
  static constexpr Eigen::Index kFirst = 4;
  static constexpr Eigen::Index kSecond = 10;
  PossibleSmoothing smoothing_;
  VectorXd area_;
  Eigen::PartialPivLU<MatrixXd> solver_;
};

/// Likelihood of levels of these coefficients, of scatter 1: the rows are rotated, and one more
/// than there are coefficients stands for all others.
void measure(const VectorXd& x, RandomStream& random, PosteriorRows& rows) {
  VectorXd data = matrix_of(rows.factor) * x;
  for (double& value : data) value += random.normal();
  double others = 0.0;
  for (auto i = static_cast<int>(x.size()); i < static_cast<int>(std::lround(rows.count)); ++i) {
    others += std::pow(random.normal(), 2);
  }
  data(x.size()) = std::sqrt(others);
  rows.data.assign(data.begin(), data.end());
}

// Of the levels' own rows, penalty and limits. The prior of ln s is flat, and the truth has s = 1,
// which matters to O(1/levels). In the studies alone: PosteriorChain.HasUniformRanks tests the
// chain that draws.
TEST(DensityPosterior, HasUniformRanks) {
  MICROSLIP_STUDY();
  constexpr std::uint64_t kTruths = 1000;
  constexpr std::size_t kKept = 19;
  constexpr std::size_t kThin = 4;  // neighbours are correlated
  constexpr std::size_t kBins = 20;
  DensityPosterior posterior = small_posterior();
  const PriorTruths truths(posterior);
  const MatrixXd density = matrix_of(posterior.density);
  const std::vector<Eigen::Index> knots = {3, 8, 11, density.rows() - 1};
  std::vector<testing::RankHistogram> ranks;
  for (const Eigen::Index knot : knots) {
    ranks.emplace_back("density at knot " + std::to_string(knot), kKept, kBins);
  }
  ranks.emplace_back("area", kKept, kBins);
  for (std::uint64_t truth = 0; truth < kTruths; ++truth) {
    RandomStream random(51, truth);
    const VectorXd x = truths.draw(random);
    measure(x, random, posterior.dissipation);
    const VectorXd expected = density * x;
    double area = 0.0;
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      area += posterior.area[static_cast<std::size_t>(j)] * x(j);
    }
    const std::vector<DensitySample> samples =
        posterior.samples(truth, kKept * kThin, Execution::serial());
    std::vector<std::size_t> rank(ranks.size(), 0);
    for (std::size_t i = kThin - 1; i < samples.size(); i += kThin) {
      for (std::size_t k = 0; k < knots.size(); ++k) {
        const auto knot = static_cast<std::size_t>(knots[k]);
        rank[k] += samples[i].density[knot] < expected(knots[k]) ? 1 : 0;
      }
      rank.back() += samples[i].area < area ? 1 : 0;
    }
    for (std::size_t k = 0; k < rank.size(); ++k) ranks[k].add(rank[k]);
  }
  for (const testing::RankHistogram& one : ranks) {
    EXPECT_GT(one.uniformity(), 0.01) << one.name();
    test::record_smallest("uniform ranks, p [1]", one.uniformity());
  }
}

// Whatever the count and the threads, of one chain or of several.
TEST(DensityPosterior, DrawsAreFunctionsOfSeedAndIndex) {
  const DensityPosterior posterior = small_posterior();
  const std::vector<DensitySample> many = posterior.samples(4, 600);
  const std::vector<DensitySample> few = posterior.samples(4, 260, Execution::serial());
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].density, many[i].density) << i;
  EXPECT_NE(many[0].density, many[posterior.chain_length()].density);
  EXPECT_NE(posterior.samples(5, 1)[0].density, many[0].density);
}

// The two kinds of rows have scatters of their own, k_eq at least that stated: a k_eq that fits to
// a tenth of its deviation does not narrow the band ten times.
TEST(DensityPosterior, KeepsToTheDeviationsOfSecantStiffness) {
  const Joint truth = testing::reference_joint();
  Levels levels = testing::noisy_levels(truth, 11);
  testing::add_secant(truth, 1e-4, 11, levels);
  const auto width = [&](double deviation) {
    levels.secant_stiffness_std.assign(levels.size(), deviation * kStiffness);
    const InversionResult result = invert(levels, kStiffness);
    double least = 1.0;
    double most = 0.0;
    for (const DensitySample& sample : result.posterior.samples(1, 250)) {
      const double at = testing::density_at(result.slip_force, sample.density, 25.0);
      least = std::min(least, at);
      most = std::max(most, at);
    }
    return most - least;
  };
  EXPECT_GT(width(1e-2), 1.5 * width(1e-4));
}

}  // namespace
}  // namespace microslip::density_posterior_test
