// SPDX-License-Identifier: MIT
#include "microslip/calibrate/joint_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/median.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"

namespace microslip {
namespace {

/// Share of a loss that the knots follow a density with kinks to, as for levels of one joint: less
/// scatter proves no edge.
constexpr double kResolvedLoss = 3e-3;
/// Degrees of freedom that the levels must leave the scatter.
constexpr double kLeastFreedom = 10.0;
/// Edges that may have to be added together before one of them is significant: the ends of one
/// population.
constexpr std::size_t kLookAhead = 2;
/// Levels in a range between edges: each shows a loss and, with frequencies, a stiffness.
constexpr Eigen::Index kLeastLevels = 2;
/// Spacings of the knots: an edge whose place is known no better may be where a density bends, or
/// falls fast.
constexpr double kLargestDeviation = 0.3;
/// Factor by which an edge may increase the smoothing.
constexpr double kMuchMore = 1e3;

double log_determinant(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  return 2.0 * factor.matrixLLT().diagonal().array().log().sum();
}

EvidenceWeights weights_of(const EdgedFit& fit) {
  EvidenceWeights weights;
  const auto kinds = static_cast<std::ptrdiff_t>(kRowKinds.size());
  weights.lambda.assign(fit.weights.begin(), fit.weights.end() - kinds);
  std::copy(fit.weights.end() - kinds, fit.weights.end(), weights.scatter.begin());
  return weights;
}

/// The unpenalised part: straight lines, and the elastic remainder of each joint.
double free_count(const LinearEvidence& evidence) {
  double count = 0.0;
  for (const RoughnessBlock& block : evidence.roughness) {
    count += 1.0 + 2.0 * static_cast<double>(block.ranges.size());
  }
  return count;
}

/// Contribution of the lines on the ranges of a joint to the Hessian and to −2 ln p.
double hold_lines(const RoughnessBlock& block, const Eigen::VectorXd& x, Eigen::MatrixXd& hessian) {
  const double size = x.segment(block.begin, block.free_count).squaredNorm() /
                          static_cast<double>(block.free_count) +
                      1e-300;
  double lines = 0.0;
  Eigen::Index begin = block.begin;
  for (const Eigen::Index count : block.ranges) {
    const double variance = static_cast<double>(count) * size;
    lines += 2.0 * std::log(variance);
    hessian.diagonal().segment(begin, count).array() += 1.0 / variance;
    begin += count;
  }
  return lines;
}

double evidence_of(const NormalEquations& equations, const SettledEvidence& settled) {
  const LinearEvidence& evidence = equations.evidence();
  double freedom = -free_count(evidence);
  for (const RowKind kind : kMeasuredKinds) {
    freedom += std::max(0.0, evidence.of(kind).count());
  }
  if (freedom < kLeastFreedom || !settled.solution.converged) {
    return std::numeric_limits<double>::infinity();
  }
  Eigen::MatrixXd hessian = with_ridge(equations.hessian(settled.weights));
  double sum = 0.0;
  for (const RowKind kind : kRowKinds) {
    const double scatter = settled.weights.of(kind);
    sum += equations.residual(kind, settled.x) / (scatter * scatter) +
           2.0 * evidence.of(kind).count() * std::log(scatter);
  }
  for (std::size_t j = 0; j < evidence.roughness.size(); ++j) {
    const RoughnessBlock& block = evidence.roughness[j];
    const double lambda = settled.weights.lambda[j];
    sum += lambda * equations.roughness(j, settled.x) + hold_lines(block, settled.x, hessian) -
           static_cast<double>(block.rows.rows()) * std::log(lambda) -
           log_determinant(block.rows * block.rows.transpose());
  }
  return sum + log_determinant(hessian);
}

/// A scatter below the resolution of the knots proves nothing.
ScatterBounds resolved(ScatterBounds bounds, const LinearisedLevels& levels) {
  std::vector<double> signal_to_noise;
  for (const LevelRow& row : levels.losses) {
    if (row.size > 0.0) signal_to_noise.push_back(row.size / row.deviation);
  }
  if (signal_to_noise.empty()) return bounds;
  const auto loss = static_cast<std::size_t>(RowKind::kLoss);
  bounds.least[loss] =
      std::max(bounds.least[loss], kResolvedLoss * median(std::move(signal_to_noise)));
  bounds.most[loss] = std::max(bounds.most[loss], bounds.least[loss]);
  return bounds;
}

}  // namespace

JointEdges::JointEdges(const CalibrationEvidence& evidence, const LinearisedLevels& levels,
                       AllUnknowns unknowns, std::size_t joint, const ScatterBounds& bounds)
    : evidence_(evidence),
      levels_(levels),
      unknowns_(std::move(unknowns)),
      joint_(joint),
      bounds_(resolved(bounds, levels)) {}

AllUnknowns JointEdges::with(const std::vector<BasisEdge>& edges) const {
  return unknowns_.with(joint_, unknowns_.of(joint_).with_edges(edges));
}

EdgedFit JointEdges::start(const EvidenceWeights& weights) {
  EdgedFit fit;
  fit.weights = weights.lambda;
  fit.weights.insert(fit.weights.end(), weights.scatter.begin(), weights.scatter.end());
  return fit;
}

EdgedFit JointEdges::present(const EvidenceWeights& weights) {
  return fit(unknowns_.of(joint_).basis_edges(), 0.0, start(weights), false);
}

EdgedFit JointEdges::find(const EdgedFit& start) {
  return distinguished_from_bends(search().find(start));
}

EdgedFit JointEdges::kept(const EvidenceWeights& weights) {
  return distinguished_from_bends(search().renewed(present(weights)));
}

EdgedFit JointEdges::distinguished_from_bends(EdgedFit found) {
  EdgeSearch one = search();
  while (!found.edges.empty()) {
    const std::vector<double> deviations = one.deviations(found);
    const auto vaguest = std::ranges::max_element(deviations);
    if (*vaguest <= kLargestDeviation) break;
    std::vector<BasisEdge> others = found.edges;
    others.erase(others.begin() + (vaguest - deviations.begin()));
    found = one.renewed(fit(std::move(others), 0.0, found, false));
  }
  return found;
}

double JointEdges::evidence_without(const std::vector<bool>& empty,
                                    const EvidenceWeights& start) const {
  const LinearEvidence linear =
      in_terms_of(evidence_, unknowns_.with(joint_, unknowns_.of(joint_).without(empty)), levels_);
  const NormalEquations equations(linear);
  return evidence_of(equations, settle(equations, start, bounds_));
}

EdgedFit JointEdges::fit(std::vector<BasisEdge> edges, double trend, const EdgedFit& start,
                         bool coarse) {
  const LinearEvidence linear = in_terms_of(evidence_, with(edges), levels_);
  const NormalEquations equations(linear);
  EdgedFit best{.edges = std::move(edges), .trend = trend, .weights = start.weights};
  const auto try_from = [&](const EvidenceWeights& weights) {
    const SettledEvidence settled = settle(equations, weights, bounds_);
    const double evidence = evidence_of(equations, settled);
    if (!(evidence < best.evidence)) return;
    best.weights = JointEdges::start(settled.weights).weights;
    best.evidence = evidence;
  };
  EvidenceWeights weights = weights_of(start);
  try_from(weights);
  if (!coarse) return best;
  weights.lambda[joint_] = std::min(kMostLambda, kMuchMore * weights.lambda[joint_]);
  try_from(weights);
  return best;
}

SolutionBends JointEdges::bends(const EdgedFit& fit) {
  const AllUnknowns unknowns = with(fit.edges);
  const LinearEvidence linear = in_terms_of(evidence_, unknowns, levels_);
  const NormalEquations equations(linear);
  const EvidenceWeights weights = weights_of(fit);
  const SettledEvidence settled = settle_with(equations, weights);
  const std::vector<Eigen::Index> free = free_coefficients(settled.solution);
  const RoughnessBlock& block = linear.roughness[joint_];
  Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(block.rows.rows(), linear.size());
  penalty.middleCols(block.begin, block.free_count) = block.rows;
  const Eigen::MatrixXd own = penalty(Eigen::all, free);
  const Eigen::MatrixXd hessian = with_ridge(equations.hessian(weights))(free, free);
  const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
  return {.bend = penalty * settled.x,
          .bound = weights.lambda[joint_] * own * factor.solve(own.transpose()),
          .middles = unknowns.of(joint_).middles()};
}

EdgeSearch JointEdges::search() {
  const JointUnknowns& own = unknowns_.of(joint_);
  Eigen::VectorXd amplitude(static_cast<Eigen::Index>(levels_.amplitude.size()));
  for (std::size_t i = 0; i < levels_.amplitude.size(); ++i) {
    amplitude(static_cast<Eigen::Index>(i)) = levels_.amplitude[i][joint_] / own.length();
  }
  return {*this,
          {.uniform = own.uniform(),
           .amplitude = std::move(amplitude),
           .coefficients = own.coefficients(),
           .look_ahead = kLookAhead,
           .trend = false,
           .least_levels = kLeastLevels}};
}

std::vector<double> JointEdges::slip_displacements(const std::vector<BasisEdge>& edges) const {
  return unknowns_.of(joint_).with_edges(edges).edges();
}

}  // namespace microslip
