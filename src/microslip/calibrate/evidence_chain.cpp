// SPDX-License-Identifier: MIT
#include "microslip/calibrate/evidence_chain.hpp"

#include <cmath>
#include <utility>

#include "microslip/base/random.hpp"
#include "microslip/identify/posterior/posterior_chain.hpp"
#include "microslip/identify/posterior/truncated_gaussian.hpp"

namespace microslip {
namespace {

/// Draws of the prior before those that are kept, over these.
constexpr std::size_t kForgottenShare = 5;
/// Start of a coefficient that lies on its limit, in standard deviations without the limits.
constexpr double kInside = 1e-3;
/// The most reflections of a trajectory of the prior: it hardly ever has a hundredth of them.
constexpr int kMostReflections = 20'000;

LinearLimits non_negative(Eigen::Index size) { return {size, Eigen::VectorXd::Zero(size)}; }

ChainRows chain_rows(const LinearEvidence& evidence, RowKind kind, double least) {
  const WeightedRows& rows = evidence.of(kind);
  return {.design = rows.design,
          .data = rows.data,
          .shift = {},
          .count = rows.count(),
          .least_scale = least,
          .scale_known = kind == RowKind::kMode || kind == RowKind::kStiffness};
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
  ChainTarget target{.rows = {},
                     .penalty = settled_penalty(evidence, settled),
                     .limits = non_negative(evidence.size()),
                     .blocks = {}};
  for (std::size_t j = 0; j < evidence.roughness.size(); ++j) {
    const double lambda = settled.weights.lambda[j];
    target.blocks.push_back(
        {evidence.roughness[j].rows.rows(), kLeastLambda / lambda, kMostLambda / lambda});
  }
  ChainStart start{settled.x, 1.0, {}};
  for (const RowKind kind : kRowKinds) {
    if (!evidence.of(kind).has_freedom()) continue;
    target.rows.push_back(chain_rows(evidence, kind, least[static_cast<std::size_t>(kind)]));
    start.scale.push_back(settled.weights.of(kind));
  }
  if (length.draws == 0) return;
  PosteriorChain chain(target, std::move(start));
  RandomStream random(length.seed, 2 * length.chain);
  chain.settle(random);
  for (std::size_t i = 0; i < length.draws; ++i) {
    chain.next(random);
    keep(chain.projected(random).x);
  }
}

void draw_prior(const NormalEquations& equations, const SettledEvidence& settled,
                const ChainLength& length,
                const std::function<void(const Eigen::VectorXd&)>& keep) {
  const LinearLimits limits = non_negative(equations.evidence().size());
  TruncatedGaussian prior(limits);
  prior.set(equations.prior_hessian(settled.weights), equations.prior_linear());
  Eigen::VectorXd x = limits.moved_inside(settled.x, kInside * prior.standard_deviation());
  RandomStream random(length.seed, 2 * length.chain + 1);
  const std::size_t forgotten = length.draws / kForgottenShare;
  for (std::size_t i = 0; i < forgotten + length.draws; ++i) {
    prior.move(x, random, kMostReflections);
    if (i >= forgotten) keep(x);
  }
}

}  // namespace microslip
