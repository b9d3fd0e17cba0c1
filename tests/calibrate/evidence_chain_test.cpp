// SPDX-License-Identifier: MIT
#include "microslip/calibrate/evidence_chain.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::evidence_chain_test {
namespace {

constexpr Eigen::Index kCount = 14;  // coefficients of a joint, and one that is free of roughness
constexpr double kNoise = 0.1;

RoughnessBlock roughness_of(Eigen::Index begin) {
  RoughnessBlock block{begin, kCount, Eigen::MatrixXd::Zero(kCount - 2, kCount)};
  for (Eigen::Index i = 0; i + 2 < kCount; ++i) {
    block.rows(i, i) = block.rows(i, i + 2) = 1.0;
    block.rows(i, i + 1) = -2.0;
  }
  return block;
}

/// Two joints whose coefficients are measured one by one: those of the first alternate, those of
/// the second lie on a straight line and are measured at every third place only.
LinearEvidence rough_and_smooth() {
  const Eigen::Index size = 2 * (kCount + 1);
  LinearEvidence evidence;
  WeightedRows& losses = evidence.of(RowKind::kLoss);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < kCount; ++i) seen.push_back(i);
  for (Eigen::Index i = 0; i < kCount; i += 3) seen.push_back(kCount + 1 + i);
  losses.design = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(seen.size()), size);
  losses.data.resize(losses.design.rows());
  RandomStream random(4, 0);
  for (Eigen::Index r = 0; r < losses.data.size(); ++r) {
    const Eigen::Index at = seen[static_cast<std::size_t>(r)];
    const bool first = at < kCount;
    const double truth = first ? 5.0 + 3.0 * (at % 2 == 0 ? 1.0 : -1.0)
                               : 4.0 + 0.2 * static_cast<double>(at - kCount - 1);
    losses.design(r, at) = 1.0 / kNoise;
    losses.data(r) = truth / kNoise + random.normal();
  }
  for (const RowKind none : {RowKind::kFrequency, RowKind::kAmplitude}) {
    evidence.of(none).design.resize(0, size);
    evidence.of(none).data.resize(0);
  }
  WeightedRows& stiffness = evidence.of(RowKind::kStiffness);
  stiffness.design = Eigen::MatrixXd::Zero(2, size);
  stiffness.design(0, kCount) = stiffness.design(1, 2 * kCount + 1) = 1.0 / kKnownStiffness;
  stiffness.data = Eigen::VectorXd::Constant(2, 1.0 / kKnownStiffness);
  evidence.roughness = {roughness_of(0), roughness_of(kCount + 1)};
  return evidence;
}

/// Standard deviation of the draws at a coefficient that was not measured.
double spread_between(const LinearEvidence& evidence, const std::vector<double>& lambda) {
  const NormalEquations equations(evidence);
  EvidenceWeights weights;
  weights.lambda = lambda;
  const SettledEvidence settled = settle_with(equations, weights);
  double sum = 0.0;
  double square = 0.0;
  double count = 0.0;
  draw_evidence(equations, settled, {1.0, 1.0, 1.0, 1.0}, {2000, 3}, [&](const Eigen::VectorXd& x) {
    const double value = x(kCount + 1 + 7);
    sum += value;
    square += value * value;
    count += 1.0;
  });
  return std::sqrt(square / count - sum * sum / count / count);
}

// The posterior of a smooth joint does not depend on where the search for its smoothing ended: λ
// is drawn for each joint. 2000 correlated draws determine a spread with heavy tails to some 15 %.
TEST(EvidenceChain, DrawsTheSmoothingOfEachJoint) {
  const LinearEvidence evidence = rough_and_smooth();
  const double smooth = spread_between(evidence, {1e-2, 1e3});
  const double rough = spread_between(evidence, {1e-2, 1e-2});
  EXPECT_NEAR(rough / smooth, 1.0, 0.3);
}

// A joint of which the first half does not slip: 0 in truth, and a half of its coefficients would
// have to be 0 at once. Their sum is 0, or almost 0, in some of the draws, so that a band can begin
// there.
TEST(EvidenceChain, DrawsReachAJointThatDoesNotSlip) {
  LinearEvidence evidence = rough_and_smooth();
  WeightedRows& losses = evidence.of(RowKind::kLoss);
  RandomStream random(5, 0);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    losses.data(i) = (i < kCount / 2 ? 0.0 : 5.0) / kNoise + random.normal();
  }
  const NormalEquations equations(evidence);
  EvidenceWeights weights;
  weights.lambda = {1e-2, 1e-2};
  double next_to_nothing = 0.0;
  draw_evidence(equations, settle_with(equations, weights), {1.0, 1.0, 1.0, 1.0}, {400, 3},
                [&](const Eigen::VectorXd& x) {
                  next_to_nothing += x.head(2).sum() < 0.01 * kNoise ? 1.0 : 0.0;
                });
  EXPECT_GT(next_to_nothing, 0.025 * 400);
}

}  // namespace
}  // namespace microslip::evidence_chain_test
