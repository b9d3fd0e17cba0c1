// SPDX-License-Identifier: MIT
#include "microslip/calibrate/evidence_chain.hpp"

#include <cmath>
#include <utility>

#include "microslip/base/random.hpp"
#include "microslip/identify/posterior_chain.hpp"
#include "microslip/identify/truncated_gaussian.hpp"

namespace microslip {
namespace {

/// How far the smoothing of all joints together may go from where it settled: farther than it does.
constexpr double kSmoothingRange = 1e3;
/// Draws of the prior before those that are kept, over these.
constexpr std::size_t kForgottenShare = 5;
/// Where a coefficient starts that lies on its limit, in standard deviations without the limits.
constexpr double kInside = 1e-3;
/// A trajectory of the prior ends here at the latest: its variance needs no more.
constexpr int kMostReflections = 1000;

LinearLimits non_negative(Eigen::Index size) { return {size, Eigen::VectorXd::Zero(size)}; }

/// Known stiffnesses count with the losses: at their deviation what τ of these is does not matter.
ChainRows loss_rows(const LinearEvidence& evidence, double least) {
  const WeightedRows& losses = evidence.of(RowKind::kLoss);
  const WeightedRows& known = evidence.of(RowKind::kStiffness);
  ChainRows rows;
  rows.design.resize(losses.design.rows() + known.design.rows(), evidence.size());
  rows.design << losses.design, known.design;
  rows.data.resize(rows.design.rows());
  rows.data << losses.data, known.data;
  rows.count = losses.count() + static_cast<double>(known.data.size());
  rows.least_scale = least;
  return rows;
}

ChainRows frequency_rows(const LinearEvidence& evidence, double least) {
  const WeightedRows& frequencies = evidence.of(RowKind::kFrequency);
  ChainRows rows;
  rows.design = frequencies.design;
  rows.data = frequencies.data;
  rows.count = frequencies.count();
  rows.least_scale = least;
  return rows;
}

Eigen::MatrixXd settled_penalty(const LinearEvidence& evidence, const SettledEvidence& settled) {
  Eigen::Index count = 0;
  for (const RoughnessBlock& block : evidence.roughness) count += block.rows.rows();
  Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(count, evidence.size());
  Eigen::Index at = 0;
  for (std::size_t j = 0; j < evidence.roughness.size(); ++j) {
    const RoughnessBlock& block = evidence.roughness[j];
    penalty.block(at, block.begin, block.rows.rows(), block.free_count) =
        std::sqrt(settled.weights.lambda[j]) * block.rows;
    at += block.rows.rows();
  }
  return penalty;
}

}  // namespace

void draw_evidence(const NormalEquations& equations, const SettledEvidence& settled,
                   const std::array<double, kRowKinds.size()>& least, const ChainLength& length,
                   const std::function<void(const Eigen::VectorXd&)>& keep) {
  const LinearEvidence& evidence = equations.evidence();
  const auto least_of = [&](RowKind kind) { return least[static_cast<std::size_t>(kind)]; };
  ChainTarget target{.rows = {loss_rows(evidence, least_of(RowKind::kLoss))},
                     .penalty = settled_penalty(evidence, settled),
                     .limits = non_negative(evidence.size()),
                     .least_lambda = 1.0 / kSmoothingRange,
                     .most_lambda = kSmoothingRange};
  ChainStart start{settled.x, 1.0, {settled.weights.of(RowKind::kLoss)}};
  if (evidence.of(RowKind::kFrequency).data.size() > 0) {
    target.rows.push_back(frequency_rows(evidence, least_of(RowKind::kFrequency)));
    start.scale.push_back(settled.weights.of(RowKind::kFrequency));
  }
  PosteriorChain chain(target, std::move(start));
  RandomStream random(length.seed, 0);
  chain.settle(random);
  for (std::size_t i = 0; i < length.draws; ++i) keep(chain.next(random));
}

void draw_prior(const NormalEquations& equations, const SettledEvidence& settled,
                const ChainLength& length,
                const std::function<void(const Eigen::VectorXd&)>& keep) {
  const LinearLimits limits = non_negative(equations.evidence().size());
  TruncatedGaussian prior(limits);
  prior.set(equations.prior_hessian(settled.weights), equations.prior_linear());
  Eigen::VectorXd x = limits.moved_inside(settled.x, kInside * prior.standard_deviation());
  RandomStream random(length.seed, 1);
  const std::size_t forgotten = length.draws / kForgottenShare;
  for (std::size_t i = 0; i < forgotten + length.draws; ++i) {
    prior.move(x, random, kMostReflections);
    if (i >= forgotten) keep(x);
  }
}

}  // namespace microslip
