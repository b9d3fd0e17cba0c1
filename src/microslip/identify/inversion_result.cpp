// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/identify/eigen_view.hpp"
#include "microslip/identify/fewer_rows.hpp"

namespace microslip {
namespace {

void read_density(const InversionModel& model, InversionResult& result) {
  const Eigen::VectorXd& x = model.solution().solution.x;
  const Eigen::VectorXd density = model.density(x);
  result.slip_force.push_back(0.0);
  result.density.push_back(density(0));
  for (Eigen::Index j = 0; j < density.size(); ++j) {
    result.slip_force.push_back(model.largest_slip_force() *
                                model.basis().knots()[static_cast<std::size_t>(j)]);
    result.density.push_back(density(j));
  }
  result.area = model.problem().area().dot(x);
  result.atom_weight = model.atom_weight(x);
}

void read_fit(const InversionModel& model, const ScaledLevels& levels, InversionResult& result) {
  const Eigen::VectorXd& x = model.solution().solution.x;
  const Eigen::VectorXd d = levels.energy * model.dissipation(x);
  result.fitted_dissipation.assign(d.begin(), d.end());
  if (levels.softening.size() == 0) return;
  const Eigen::VectorXd soft = model.softening(x);
  const Eigen::ArrayXd weight = model.weights().tail(soft.size()).array();  // 1/σ
  const Eigen::ArrayXd precision = weight.square();
  const double offset = (precision * (soft - levels.softening).array()).sum() / precision.sum();
  result.secant_offset = levels.stiffness * offset;
  const double common = weight.sum() / precision.sum();
  result.secant_offset_std =
      levels.stiffness *
      (levels.evidence.secant_std_given() ? common : 1.0 / std::sqrt(precision.sum()));
  for (const double s : soft) {
    result.fitted_secant_stiffness.push_back(levels.stiffness * (1.0 - s + offset));
  }
}

void read_path(const InversionModel& model, InversionResult& result) {
  const auto rows = static_cast<double>(model.problem().rows());
  for (const SmoothingPoint& point : model.path) {
    result.path.push_back({.lambda = point.lambda,
                           .edf = point.edf,
                           .residual = std::sqrt(point.residual / rows),
                           .gcv = point.gcv,
                           .likelihood = point.likelihood,
                           .kkt_residual = point.solution.kkt_residual,
                           .kkt_rounding = point.solution.rounding});
  }
  result.chosen = model.chosen;
  result.edf = model.solution().edf;
}

void summarise(const InversionModel& model, Summary& summary) {
  const QuadraticProgram::Solution& solution = model.solution().solution;
  summary.method = "regularised convex inversion";
  for (const SmoothingPoint& point : model.path) summary.iterations += point.solution.exchanges;
  read_optimality(solution, "optimality conditions", summary);
}

void read_scatter(const InversionModel& model, const ScaledLevels& levels,
                  InversionResult& result) {
  result.scatter = model.scatter * levels.unit.dissipation;
  result.scatter_is_relative = !levels.evidence.dissipation_std_given();
  result.dissipation_scatter = model.dissipation_scatter * result.scatter;
  if (levels.evidence.secant_std_given()) {
    result.secant_scatter = model.softening_scatter * model.scatter;
  }
}

std::vector<double> plain(const Eigen::VectorXd& v) { return {v.begin(), v.end()}; }

PlainMatrix plain_matrix(const Eigen::MatrixXd& m) {
  PlainMatrix result;
  result.columns = static_cast<std::size_t>(m.cols());
  for (const auto& row : m.rowwise()) {
    result.values.insert(result.values.end(), row.begin(), row.end());
  }
  return result;
}

PosteriorRows rows_of(const Eigen::MatrixXd& design, const Eigen::VectorXd& loss,
                      const Eigen::VectorXd& data) {
  const Eigen::Index n = design.cols();
  Eigen::MatrixXd all(design.rows(), n + (loss.size() > 0 ? 2 : 1));
  all.leftCols(n) = design;
  if (loss.size() > 0) all.col(n) = loss;
  all.rightCols(1) = data;
  const Eigen::MatrixXd factor = fewer_rows(all);
  PosteriorRows rows;
  rows.factor = plain_matrix(factor.leftCols(n));
  if (loss.size() > 0) rows.linear_loss = plain(factor.col(n));
  rows.data = plain(factor.rightCols(1));
  return rows;
}

/// Levels without noise leave none.
double start_scatter(const InversionModel& model) { return std::max(model.scatter, 1e-6); }

/// From end to end of the path, or the one that was fixed.
PossibleSmoothing possible_smoothing(const InversionModel& model) {
  const double scatter = start_scatter(model);
  const double of_unit = 1.0 / (scatter * scatter);
  PossibleSmoothing possible;
  possible.chosen = of_unit * model.solution().lambda;
  possible.least = possible.chosen;
  possible.most = possible.chosen;
  if (model.lambda_fixed) return possible;
  possible.least = of_unit * model.path.back().lambda;
  possible.most = of_unit * model.path.front().lambda;
  return possible;
}

/// W·W_lin of the rows of D; nothing where it is not known.
Eigen::VectorXd weighted_loss(const InversionModel& model, const ScaledLevels& levels) {
  const std::vector<double>& loss = levels.evidence.levels().linear_dissipation;
  if (loss.empty()) return {};
  const Eigen::Index n = model.dissipation_rows();
  return model.weights().head(n).cwiseProduct(view_of(loss)) / levels.energy;
}

DensityPosterior posterior_of(const InversionModel& model, const ScaledLevels& levels) {
  const SmoothingProblem& problem = model.problem();
  const Eigen::Index n = model.dissipation_rows();
  DensityPosterior posterior;
  const Eigen::MatrixXd at_knots = model.density_matrix();
  Eigen::MatrixXd density(at_knots.rows() + 1, at_knots.cols());
  density << at_knots.row(0), at_knots;  // from 0 on it is constant up to the first knot
  posterior.density = plain_matrix(density);
  posterior.area = plain(problem.area());
  posterior.linear_damping = plain(model.stiffness() * model.linear_damping_row());
  posterior.atom_weight = plain(model.atom_row());
  const Eigen::Index softening_rows = problem.rows() - n;
  posterior.dissipation =
      rows_of(problem.design().topRows(n), weighted_loss(model, levels), problem.data().head(n));
  posterior.dissipation.more_square = model.repeat_residual();
  double rows = model.informative_rows();
  if (softening_rows > 0) {
    posterior.secant = rows_of(problem.design().bottomRows(softening_rows), {},
                               problem.data().tail(softening_rows));
    posterior.secant.count = static_cast<double>(softening_rows) - 1.0;  // less the offset
    rows -= posterior.secant.count;
    posterior.secant.least_scatter = model.scatter * model.least_softening_scatter;
  }
  posterior.dissipation.count = std::max(1.0, rows) + model.repeat_freedom();
  posterior.scatter = start_scatter(model);
  posterior.common_errors = levels.evidence.common_errors();
  posterior.penalty = plain_matrix(problem.penalty());
  posterior.smoothing = possible_smoothing(model);
  posterior.start = plain(model.solution().solution.x);
  return posterior;
}

constexpr std::string_view kUnchangedResult = "Take a result of invert(), unchanged.";

void check_count_of(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(fmt::format("number of values of {} in the result", what),
                   static_cast<double>(length), fmt::format("must be {}", expected),
                   std::string(kUnchangedResult));
}

}  // namespace

void InversionResult::check() const {
  if (chosen >= path.size() || slip_force.empty() || fitted_dissipation.empty()) {
    throw InputError("result of the inversion", "empty", "must be one that was found",
                     std::string(kUnchangedResult));
  }
  check_count_of("density", density.size(), slip_force.size());
  check_count_of("slip_force in the posterior", posterior.slip_force.size(), slip_force.size());
  if (fitted_secant_stiffness.empty()) return;
  check_count_of("fitted_secant_stiffness", fitted_secant_stiffness.size(),
                 fitted_dissipation.size());
}

void read_model(const InversionModel& model, const ScaledLevels& levels, InversionResult& result) {
  read_density(model, result);
  read_fit(model, levels, result);
  read_path(model, result);
  read_scatter(model, levels, result);
  summarise(model, result.summary);
  result.posterior = posterior_of(model, levels);
  result.posterior.slip_force = result.slip_force;
}

}  // namespace microslip
