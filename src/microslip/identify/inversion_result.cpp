// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion_result.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"

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

/// R of rows = QR: RᵀR is their share of the information.
PlainMatrix factor_of(const Eigen::MatrixXd& rows) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  const Eigen::Index size = std::min(rows.rows(), rows.cols());
  return plain_matrix(qr.matrixQR().topRows(size).triangularView<Eigen::Upper>());
}

/// λ with their likelihood, within the guard; or the one that was fixed.
std::vector<PossibleSmoothing> possible_smoothing(const InversionModel& model) {
  const SmoothingPoint& solution = model.solution();
  if (model.lambda_fixed) return {{solution.lambda, 1.0, plain(solution.solution.x)}};
  const auto possible = [&](const SmoothingPoint& point) { return point.edf <= model.most_edf; };
  double lowest = solution.likelihood;
  for (const SmoothingPoint& point : model.path) {
    if (possible(point)) lowest = std::min(lowest, point.likelihood);
  }
  std::vector<PossibleSmoothing> all;
  for (const SmoothingPoint& point : model.path) {
    if (!possible(point)) continue;
    const double weight = std::exp(-0.5 * (point.likelihood - lowest));
    all.push_back({point.lambda, weight, plain(point.solution.x)});
  }
  if (all.empty()) all.push_back({solution.lambda, 1.0, plain(solution.solution.x)});
  return all;
}

/// KᵀW²d of W_lin; nothing where it is not known.
std::vector<double> projected_loss(const InversionModel& model, const ScaledLevels& levels) {
  const std::vector<double>& loss = levels.evidence.levels().linear_dissipation;
  if (loss.empty()) return {};
  const Eigen::Index n = model.dissipation_rows();
  const Eigen::VectorXd scaled = Eigen::Map<const Eigen::VectorXd>(loss.data(), n) / levels.energy;
  return plain(model.problem().design().topRows(n).transpose() *
               model.weights().head(n).cwiseProduct(scaled));
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
  posterior.information = plain_matrix(problem.hessian(0.0));
  posterior.data = plain(problem.linear());
  posterior.dissipation_factor = factor_of(problem.design().topRows(n));
  if (problem.rows() > n) {
    posterior.secant_factor = factor_of(problem.design().bottomRows(problem.rows() - n));
  }
  posterior.linear_loss = projected_loss(model, levels);
  posterior.scatter = model.scatter;
  posterior.dissipation_scatter = model.scatter * model.dissipation_scatter;
  posterior.secant_scatter =
      model.scatter * std::max(model.softening_scatter, model.least_softening_scatter);
  posterior.degrees_of_freedom = model.degrees_of_freedom;
  posterior.common_errors = levels.evidence.common_errors();
  posterior.penalty = plain_matrix(problem.penalty());
  posterior.smoothing = possible_smoothing(model);
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
