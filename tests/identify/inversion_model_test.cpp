// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/eigenvalues.hpp"

#include "support/densities.hpp"

namespace microslip::inversion_model_test {
namespace {

using testing::kStiffness;

PassOptions pass_with(const ScaledLevels& levels, std::vector<BasisEdge> edges) {
  PassOptions pass;
  pass.fit = levels.typical;
  pass.coefficients = 24;
  pass.edges = std::move(edges);
  return pass;
}

/// −2 log of the density of y ~ N(0, σ²(I + A P⁻¹ Aᵀ)), less m ln 2π, from the matrices
/// themselves: P = λLᵀL and the precision of the unpenalised part, on each range between edges
/// that of its size.
double dense_evidence(const InversionModel& model, const SmoothingPoint& point) {
  const SmoothingProblem& problem = model.problem();
  // Levels near the floor of the weights count as less than one.
  const double rows = model.informative_rows();
  const double freedom = rows - static_cast<double>(problem.unpenalised());
  const double variance = (point.residual + point.lambda * point.roughness) / freedom;
  const Eigen::VectorXd theta = model.theta(point.solution.x);
  const double size = theta.squaredNorm() / static_cast<double>(theta.size());
  Eigen::MatrixXd prior = point.lambda * problem.penalty().transpose() * problem.penalty();
  Eigen::Index begin = 0;
  for (Eigen::Index range = 0; range < model.basis().ranges(); ++range) {
    const Eigen::Index count = model.basis().size_of(range);
    // Straight lines: the unpenalised part of a range.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(
        Eigen::MatrixXd(prior.block(begin, begin, count, count)));
    const Eigen::MatrixXd lines = spectrum.eigenvectors().leftCols(2);
    prior.block(begin, begin, count, count) +=
        variance / (static_cast<double>(count) * size) * lines * lines.transpose();
    begin += count;
  }
  const Eigen::MatrixXd& a = problem.design();
  const Eigen::MatrixXd covariance =
      variance * (Eigen::MatrixXd::Identity(a.rows(), a.rows()) +
                  a * prior.ldlt().solve(Eigen::MatrixXd(a.transpose())));
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  const Eigen::MatrixXd lower = factor.matrixL();
  return 2.0 * lower.diagonal().array().log().sum() +
         factor.matrixL().solve(problem.data()).squaredNorm() +
         (rows - static_cast<double>(problem.rows())) * std::log(variance);
}

// 10 % of noise, compared with which the resolution of the basis, 0.3 %, is negligible. Where no
// limit holds a coefficient the likelihood has a closed form. evidence() neglects the pull of the
// prior of the straight lines on the solution: up to 1 per range, 0.6 to 0.97 here.
TEST(InversionModel, EvidenceIsTheMarginalLikelihood) {
  const LevelEvidence evidence(testing::noisy_levels(testing::uniform_beyond_range(), 3, 0.1));
  const ScaledLevels levels(evidence, kStiffness);
  int compared = 0;
  for (const std::vector<BasisEdge>& edges :
       std::vector<std::vector<BasisEdge>>{{}, {{12, 12.3}}, {{8, 8.0}, {16, 15.6}}}) {
    const InversionModel model(levels, pass_with(levels, edges));
    for (const double share : {1e-2, 1.0, 1e2, 1e4}) {
      const double lambda = share * model.problem().lambda_grid(3)[1];
      const SmoothingPoint point = model.problem().solve(
          lambda, std::vector<bool>(static_cast<std::size_t>(model.problem().size()), true));
      if (!std::ranges::all_of(point.solution.free, [](bool free) { return free; })) continue;
      ++compared;
      const auto ranges = static_cast<double>(model.basis().ranges());
      const double left_out = dense_evidence(model, point) - model.evidence(point);
      EXPECT_GT(left_out, -0.1) << edges.size() << " edges, λ " << lambda;
      EXPECT_LT(left_out, ranges + 0.1) << edges.size() << " edges, λ " << lambda;
    }
  }
  EXPECT_GE(compared, 9);
}

}  // namespace
}  // namespace microslip::inversion_model_test
