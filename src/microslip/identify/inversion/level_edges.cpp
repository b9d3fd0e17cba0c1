// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/level_edges.hpp"

#include <cmath>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/identify/inversion/edge_search.hpp"

namespace microslip {
namespace {

/// Steps of λ without success before the search of it ends.
constexpr int kPatience = 4;
constexpr int kMostSteps = 60;

/// Levels of one joint with edges in its density; the weight is λ.
class EdgedLevels final : public EdgedModel {
 public:
  EdgedLevels(const ScaledLevels& levels, PassOptions pass, InnerSolutions& inner)
      : levels_(levels), pass_(std::move(pass)), inner_(inner) {}

  EdgedFit fit(std::vector<BasisEdge> edges, double trend, const EdgedFit& start,
               bool coarse) override;
  SolutionBends bends(const EdgedFit& fit) override;

  [[nodiscard]] EdgeSearch search() {
    return {*this,
            {.uniform = {levels_.amplitude(0), pass_.top, pass_.exponent, pass_.coefficients},
             .amplitude = levels_.amplitude,
             .coefficients = pass_.coefficients}};
  }

 private:
  const ScaledLevels& levels_;
  PassOptions pass_;
  InnerSolutions& inner_;
};

EdgedFit EdgedLevels::fit(std::vector<BasisEdge> edges, double trend, const EdgedFit& start,
                          bool coarse) {
  pass_.edges = edges;
  pass_.trend = trend;
  const InversionModel model(levels_, pass_);
  const double most_edf = model.problem().most_edf();
  const double first = start.weights.front();
  EdgedFit best{.edges = std::move(edges), .trend = trend, .weights = {first}};
  std::vector<bool> free(static_cast<std::size_t>(model.problem().size()), true);
  bool too_flexible = false;
  const auto improves = [&](double lambda) {
    too_flexible = false;
    if (lambda > model.problem().stiffest()) return false;
    const SmoothingPoint point = model.problem().solve(lambda, free);
    inner_.add(point.solution);
    too_flexible = point.edf > most_edf;
    if (too_flexible) return false;
    const double evidence =
        model.evidence(point) + std::pow(trend / EdgeSearch::kTrendDeviation, 2);
    if (!(evidence < best.evidence)) return false;
    free = point.solution.free;
    best.weights.front() = lambda;
    best.evidence = evidence;
    return true;
  };
  improves(first);
  // An edge may need far more smoothing than before, with less likely λ in between.
  const double factor = coarse ? EdgeSearch::kCoarseStep : EdgeSearch::kFineStep;
  const int patience = coarse ? kPatience : 1;
  for (const double step : {factor, 1.0 / factor}) {
    double lambda = first;
    for (int in_vain = 0, i = 0; in_vain < patience && i < kMostSteps; ++i) {
      lambda *= step;
      in_vain = improves(lambda) || too_flexible ? 0 : in_vain + 1;
    }
    if (best.weights.front() != first) break;
  }
  return best;
}

SolutionBends EdgedLevels::bends(const EdgedFit& fit) {
  pass_.edges = fit.edges;
  pass_.trend = fit.trend;
  const InversionModel model(levels_, pass_);
  const SmoothingProblem& problem = model.problem();
  const double lambda = fit.weights.front();
  const SmoothingPoint point =
      problem.solve(lambda, std::vector<bool>(static_cast<std::size_t>(problem.size()), true));
  inner_.add(point.solution);
  const std::vector<Eigen::Index> free = free_coefficients(point.solution);
  const Eigen::MatrixXd penalty = problem.penalty()(Eigen::all, free);
  const Eigen::LLT<Eigen::MatrixXd> factor(problem.hessian(lambda)(free, free).eval());
  return {.bend = problem.penalty() * point.solution.x,
          .bound = lambda * penalty * factor.solve(penalty.transpose()),
          .middles = model.basis().middles()};
}

}  // namespace

void find_shape(const ScaledLevels& levels, double lambda, PassOptions& pass,
                InnerSolutions& inner) {
  EdgedLevels model(levels, pass, inner);
  EdgedFit found = model.search().find({.weights = {lambda}});
  pass.edges = std::move(found.edges);
  pass.trend = found.trend;
}

std::vector<std::vector<BasisEdge>> edges_elsewhere(const ScaledLevels& levels, double lambda,
                                                    const PassOptions& pass, std::size_t count,
                                                    InnerSolutions& inner) {
  EdgedLevels model(levels, pass, inner);
  EdgeSearch search = model.search();
  const EdgedFit fit = model.fit(pass.edges, pass.trend, {.weights = {lambda}}, false);
  return search.elsewhere(fit, search.deviations(fit), count);
}

}  // namespace microslip
