// SPDX-License-Identifier: MIT
#include "microslip/calibrate/linear_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"

namespace microslip {
namespace {

constexpr int kMostRounds = 60;
/// Weights are settled where no λ and no τ changes by more, relative; the fit changes far less.
constexpr double kSettledChange = 0.02;
/// Start of the search where the weights are unknown.
constexpr std::array kFirstLambdas = {1e-4, 1e-1, 1e2};
/// Ridge relative to each element of the diagonal: rounding, so that a factor exists.
constexpr double kRidge = 1e-13;

/// One round: the solution with given weights, and the weights estimated from it.
class Round {
 public:
  Round(const NormalEquations& equations, const EvidenceWeights& weights, std::vector<bool> start)
      : equations_(equations), weights_(weights) {
    const Eigen::MatrixXd hessian = with_ridge(equations.hessian(weights));
    const Eigen::Index n = hessian.rows();
    QuadraticProgram program(Eigen::VectorXd::Zero(n), 1.0);
    solution_ = program.solve(hessian, equations.linear(weights), std::move(start));
    const std::vector<Eigen::Index> free = free_coefficients(solution_);
    const Eigen::MatrixXd reduced = hessian(free, free);
    const Eigen::LLT<Eigen::MatrixXd> factor(reduced);
    const auto size = static_cast<Eigen::Index>(free.size());
    const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(size, size));
    inverse_ = Eigen::MatrixXd::Zero(n, n);
    inverse_(free, free) = inverse;
    const Eigen::LLT<Eigen::MatrixXd> whole(hessian);
    log_determinant_ = 2.0 * Eigen::MatrixXd(whole.matrixL()).diagonal().array().log().sum();
  }

  [[nodiscard]] const QuadraticProgram::Solution& solution() const { return solution_; }

  [[nodiscard]] double edf(RowKind kind) const {
    const double scatter = weights_.of(kind);
    return inverse_.cwiseProduct(equations_.information(kind)).sum() / (scatter * scatter);
  }

  /// The part of edf() of all that is measured due to the coefficients of each joint.
  [[nodiscard]] std::vector<double> edf_by_joint() const {
    const std::vector<RoughnessBlock>& blocks = equations_.evidence().roughness;
    std::vector<double> freedom(blocks.size(), 0.0);
    for (const RowKind kind : kMeasuredKinds) {
      const double scatter = weights_.of(kind);
      const Eigen::VectorXd own =
          inverse_.cwiseProduct(equations_.information(kind)).rowwise().sum() / (scatter * scatter);
      for (std::size_t j = 0; j < blocks.size(); ++j) {
        freedom[j] += own.segment(blocks[j].begin, blocks[j].free_count + 1).sum();
      }
    }
    return freedom;
  }

  /// r_j: rank of L_j on the free coefficients of its joint.
  [[nodiscard]] double rank(std::size_t block) const {
    const RoughnessBlock& own = equations_.evidence().roughness[block];
    Eigen::Index free = 0;
    for (Eigen::Index i = 0; i < own.free_count; ++i) {
      free += solution_.free[static_cast<std::size_t>(own.begin + i)] ? 1 : 0;
    }
    return static_cast<double>(std::min(free, own.rows.rows()));
  }

  [[nodiscard]] double next_lambda(std::size_t block) const {
    const RoughnessBlock& own = equations_.evidence().roughness[block];
    const double lambda = weights_.lambda[block];
    const double taken =
        lambda * inverse_.block(own.begin, own.begin, own.free_count, own.free_count)
                     .cwiseProduct(equations_.roughness(block))
                     .sum();
    const double rough = equations_.roughness(block, solution_.x);
    const double left = std::max(rank(block) - taken, 1e-3);
    return std::clamp(left / std::max(rough, 1e-300), kLeastLambda, kMostLambda);
  }

  [[nodiscard]] double next_scatter(RowKind kind) const {
    const WeightedRows& rows = equations_.evidence().of(kind);
    const double freedom = std::max(rows.count() - edf(kind), 0.2 * rows.count());
    return std::sqrt(equations_.residual(kind, solution_.x) / std::max(freedom, 1.0));
  }

  /// As without limits but for the residual, so that solutions with different coefficients at 0
  /// compare.
  [[nodiscard]] double likelihood() const {
    double sum = log_determinant_;
    for (const RowKind kind : kRowKinds) {
      const double scatter = weights_.of(kind);
      sum += equations_.residual(kind, solution_.x) / (scatter * scatter) +
             2.0 * equations_.evidence().of(kind).count() * std::log(scatter);
    }
    for (std::size_t j = 0; j < weights_.lambda.size(); ++j) {
      const auto rank_of_all = static_cast<double>(equations_.evidence().roughness[j].rows.rows());
      sum += weights_.lambda[j] * equations_.roughness(j, solution_.x) -
             rank_of_all * std::log(weights_.lambda[j]);
    }
    return sum;
  }

 private:
  const NormalEquations& equations_;
  const EvidenceWeights& weights_;
  QuadraticProgram::Solution solution_;
  Eigen::MatrixXd inverse_;
  double log_determinant_ = 0.0;
};

SettledEvidence read_round(const Round& now, const EvidenceWeights& weights) {
  SettledEvidence settled;
  settled.x = now.solution().x;
  settled.weights = weights;
  for (const RowKind kind : kMeasuredKinds) settled.edf += now.edf(kind);
  settled.edf_by_joint = now.edf_by_joint();
  settled.likelihood = now.likelihood();
  settled.solution = now.solution();
  return settled;
}

std::vector<bool> all_free(const NormalEquations& equations) {
  return std::vector<bool>(static_cast<std::size_t>(equations.evidence().size()), true);
}

}  // namespace

Eigen::MatrixXd with_ridge(Eigen::MatrixXd hessian) {
  hessian.diagonal() *= 1.0 + kRidge;
  return hessian;
}

NormalEquations::NormalEquations(const LinearEvidence& evidence) : evidence_(evidence) {
  for (std::size_t k = 0; k < kRowKinds.size(); ++k) {
    const WeightedRows& rows = evidence.rows[k];
    information_[k] = Eigen::MatrixXd::Zero(evidence.size(), evidence.size());
    linear_[k] = Eigen::VectorXd::Zero(evidence.size());
    if (rows.data.size() == 0) continue;
    information_[k] = rows.design.transpose() * rows.design;
    linear_[k] = rows.design.transpose() * rows.data;
  }
  for (const RoughnessBlock& block : evidence.roughness) {
    roughness_.push_back(block.rows.transpose() * block.rows);
  }
}

void NormalEquations::add_roughness(const EvidenceWeights& weights,
                                    Eigen::MatrixXd& hessian) const {
  for (std::size_t j = 0; j < roughness_.size(); ++j) {
    const RoughnessBlock& block = evidence_.roughness[j];
    hessian.block(block.begin, block.begin, block.free_count, block.free_count) +=
        weights.lambda[j] * roughness_[j];
  }
}

Eigen::MatrixXd NormalEquations::hessian(const EvidenceWeights& weights) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(evidence_.size(), evidence_.size());
  for (std::size_t k = 0; k < kRowKinds.size(); ++k) {
    sum += information_[k] / (weights.scatter[k] * weights.scatter[k]);
  }
  add_roughness(weights, sum);
  return sum;
}

Eigen::VectorXd NormalEquations::linear(const EvidenceWeights& weights) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(evidence_.size());
  for (std::size_t k = 0; k < kRowKinds.size(); ++k) {
    sum += linear_[k] / (weights.scatter[k] * weights.scatter[k]);
  }
  return sum;
}

/// Weight of the rows of k, which are over its deviation as one of the unknowns.
double NormalEquations::prior_weight() const {
  const WeightedRows& rows = evidence_.of(RowKind::kStiffness);
  const double known = 1.0 / (kKnownStiffness * rows.data(0));
  return known * known;
}

Eigen::MatrixXd NormalEquations::prior_hessian(const EvidenceWeights& weights) const {
  Eigen::MatrixXd sum =
      prior_weight() * information(RowKind::kStiffness) + information(RowKind::kMode);
  add_roughness(weights, sum);
  return with_ridge(std::move(sum));
}

Eigen::VectorXd NormalEquations::prior_linear() const {
  return prior_weight() * linear_[static_cast<std::size_t>(RowKind::kStiffness)] +
         linear_[static_cast<std::size_t>(RowKind::kMode)];
}

double NormalEquations::residual(RowKind kind, const Eigen::VectorXd& x) const {
  const WeightedRows& rows = evidence_.of(kind);
  if (rows.data.size() == 0) return 0.0;
  return (rows.design * x - rows.data).squaredNorm();
}

double NormalEquations::roughness(std::size_t block, const Eigen::VectorXd& x) const {
  const RoughnessBlock& own = evidence_.roughness[block];
  return (own.rows * x.segment(own.begin, own.free_count)).squaredNorm();
}

SettledEvidence settle_with(const NormalEquations& equations, const EvidenceWeights& weights) {
  return read_round(Round(equations, weights, all_free(equations)), weights);
}

SettledEvidence settle(const NormalEquations& equations, EvidenceWeights weights,
                       const ScatterBounds& bounds) {
  SettledEvidence settled;
  std::vector<bool> start = all_free(equations);
  for (int round = 0; round < kMostRounds; ++round) {
    const Round now(equations, weights, std::move(start));
    start = now.solution().free;
    settled = read_round(now, weights);
    double change = 0.0;
    for (std::size_t j = 0; j < weights.lambda.size(); ++j) {
      const double next = now.next_lambda(j);
      change = std::max(change, std::abs(std::log(next / weights.lambda[j])));
      weights.lambda[j] = next;
    }
    for (const RowKind kind : kMeasuredKinds) {
      if (!equations.evidence().of(kind).has_freedom()) continue;
      const auto k = static_cast<std::size_t>(kind);
      const double next = std::clamp(now.next_scatter(kind), bounds.least[k], bounds.most[k]);
      change = std::max(change, std::abs(std::log(next / weights.of(kind))));
      weights.of(kind) = next;
    }
    if (change < kSettledChange) break;
  }
  return settled;
}

SettledEvidence settle_from_afar(const NormalEquations& equations, const ScatterBounds& bounds) {
  std::optional<SettledEvidence> best;
  for (const double lambda : kFirstLambdas) {
    EvidenceWeights start;
    start.lambda.assign(equations.evidence().roughness.size(), lambda);
    start.scatter = bounds.least;
    SettledEvidence found = settle(equations, std::move(start), bounds);
    if (!best || found.likelihood < best->likelihood) best = std::move(found);
  }
  return std::move(*best);
}

}  // namespace microslip
