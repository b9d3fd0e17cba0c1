// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/identify/posterior/possible_coefficients.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/identify/smoothing/fewer_rows.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// Closer to each other, relative, two knots are one; those of an edge are not.
constexpr double kSameKnot = 1e-9;
/// Few levels leave peaks and ends of a density possible that they do not show. Beside a chain that
/// draws λ so many assume next to no smoothness: λx² of the largest coefficient x, so that a second
/// difference may be 300 of it. Chosen in view of the coverage of bands of 4 to 12 levels.
constexpr int kRoughChains = 2;
constexpr double kHardlySmoothOfFew = 1e-5;
/// Scatter of few levels, over that of the estimate.
constexpr double kMostOfFew = 4.0;
/// Deviation of LocalSmoothing where L may have a trend.
constexpr double kBesideTrend = 2.0;

std::vector<double> plain(const Eigen::VectorXd& v) { return {v.begin(), v.end()}; }

/// Slip forces of the knots, N, from 0 on.
std::vector<double> knots_of(const InversionModel& model) {
  std::vector<double> knots{0.0};
  for (const double s : model.basis().knots()) knots.push_back(model.largest_slip_force() * s);
  return knots;
}

/// The matrix that gives φ at knots that include all of the model's, 1/N, from coefficients.
Eigen::MatrixXd density_at(const InversionModel& model, const std::vector<double>& knots) {
  const Eigen::MatrixXd own = model.density_matrix();
  const std::vector<double> at = knots_of(model);
  Eigen::MatrixXd density(static_cast<Eigen::Index>(knots.size()), own.cols());
  std::size_t next = 1;  // from 0 on it is constant up to the first knot
  for (std::size_t i = 0; i < knots.size(); ++i) {
    while (next + 1 < at.size() && at[next] < knots[i]) ++next;
    const double share = std::min(1.0, (knots[i] - at[next - 1]) / (at[next] - at[next - 1]));
    const auto right = static_cast<Eigen::Index>(next) - 1;
    const auto left = std::max<Eigen::Index>(0, right - 1);
    density.row(static_cast<Eigen::Index>(i)) =
        (1.0 - share) * own.row(left) + share * own.row(right);
  }
  return density;
}

/// The knots of all models together, without those that differ by rounding.
std::vector<double> common_knots(const InversionModel& model,
                                 const std::vector<InversionModel>& elsewhere) {
  std::vector<double> all = knots_of(model);
  for (const InversionModel& other : elsewhere) {
    const std::vector<double> more = knots_of(other);
    all.insert(all.end(), more.begin(), more.end());
  }
  std::ranges::sort(all);
  const auto same = [](double a, double b) { return b - a <= kSameKnot * b; };
  all.erase(std::ranges::unique(all, same).begin(), all.end());
  return all;
}

void read_density(const InversionModel& model, InversionResult& result) {
  const Eigen::VectorXd& x = model.solution().solution.x;
  result.density = plain(density_at(model, result.slip_force) * x);
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

/// The range of λ of the path, or the fixed one.
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

/// What few levels leave open: D between levels, all high, or low in every other gap, and k_eq at
/// both ends of their range, high or low. Gaps deviate by themselves: the rise of −2 ln p is that
/// of one, times half of their number.
void set_goals(const InversionModel& model, const ScaledLevels& levels,
               DensityPosterior& posterior) {
  const std::vector<double>& knots = posterior.slip_force;
  const Eigen::VectorXd& a = levels.amplitude;
  const Eigen::Index gaps = a.size() - 1;
  const Eigen::VectorXd between = (a.head(gaps).array() * a.tail(gaps).array()).sqrt();
  std::vector<double> s;  // the first is 0, to where the density is constant
  for (std::size_t i = 1; i < knots.size(); ++i) s.push_back(knots[i] / levels.largest_slip_force);
  const Eigen::MatrixXd density =
      levels.largest_slip_force *
      density_at(model, knots).bottomRows(static_cast<Eigen::Index>(s.size()));
  Eigen::MatrixXd d = dissipation_rows(between, s) * density +
                      between.cwiseAbs2() * model.linear_damping_row().transpose();
  d = d.rowwise().sum().cwiseMax(1e-300).cwiseInverse().asDiagonal() * d;
  const Eigen::MatrixXd soft = softening_rows(Eigen::Vector2d(a(0), 1.0), s) * density;
  Eigen::MatrixXd goals = Eigen::MatrixXd::Zero(7, d.cols());
  for (Eigen::Index i = 0; i < gaps; ++i) {
    goals.row(0) += d.row(i);
    goals.row(1 + i % 2) -= d.row(i);
  }
  goals.middleRows(3, 2) = soft;
  goals.middleRows(5, 2) = -soft;
  posterior.goals = plain_matrix(goals);
  constexpr double kOfOne = PossibleCoefficients::kNineteenOfTwenty;
  posterior.rises.assign(7, kOfOne);
  const double of_gaps = kOfOne * std::max(1.0, 0.5 * static_cast<double>(gaps));
  std::fill_n(posterior.rises.begin(), 3, of_gaps);
}

DensityPosterior posterior_of(const InversionModel& model, const ScaledLevels& levels,
                              const std::vector<double>& knots) {
  const SmoothingProblem& problem = model.problem();
  const Eigen::Index n = model.dissipation_rows();
  DensityPosterior posterior;
  posterior.slip_force = knots;
  posterior.density = plain_matrix(density_at(model, knots));
  posterior.area = plain(problem.area());
  posterior.linear_damping = plain(model.stiffness() * model.linear_damping_row());
  posterior.atom_weight = plain(model.atom_row());
  const Eigen::Index softening_rows = problem.rows() - n;
  posterior.dissipation =
      rows_of(problem.design().topRows(n), weighted_loss(model, levels), problem.data().head(n));
  posterior.dissipation.more_square = model.known_scatter().square;
  double rows = model.informative_rows();
  if (softening_rows > 0) {
    posterior.secant = rows_of(problem.design().bottomRows(softening_rows), {},
                               problem.data().tail(softening_rows));
    const double independent = static_cast<double>(softening_rows) - 1.0;  // less the offset
    rows -= independent;
    posterior.secant.count = independent + model.known_softening_scatter().freedom;
    posterior.secant.more_square = model.known_softening_scatter().square;
    posterior.secant.least_scatter = model.scatter * model.least_softening_scatter;
  }
  posterior.dissipation.count = std::max(1.0, rows) + model.known_scatter().freedom;
  posterior.scatter = start_scatter(model);
  posterior.reaches_limits = model.few_levels();
  // A straight line with an enormous scatter is no explanation of levels that a density follows.
  if (model.few_levels()) posterior.dissipation.most_scatter = kMostOfFew * posterior.scatter;
  posterior.common_errors = levels.evidence.common_errors();
  posterior.penalty = plain_matrix(problem.penalty());
  posterior.smoothing = possible_smoothing(model);
  if (model.shape_sought) posterior.local_deviation = kBesideTrend;
  posterior.start = plain(model.solution().solution.x);
  return posterior;
}

/// The posterior with next to no smoothness; with more, the more levels there are to choose it.
DensityPosterior hardly_smooth(const InversionModel& model, DensityPosterior posterior) {
  const double largest = std::max(1.0, model.solution().solution.x.maxCoeff());
  const double lambda = std::pow(kHardlySmoothOfFew, model.few_share()) / (largest * largest);
  posterior.smoothing = {.least = lambda, .most = lambda, .chosen = lambda};
  return posterior;
}

}  // namespace

void read_model(const InversionModel& model, const std::vector<InversionModel>& elsewhere,
                const ScaledLevels& levels, InversionResult& result) {
  result.slip_force = common_knots(model, elsewhere);
  read_density(model, result);
  read_fit(model, levels, result);
  read_path(model, result);
  read_scatter(model, levels, result);
  summarise(model, result.summary);
  result.posterior = posterior_of(model, levels, result.slip_force);
  for (const InversionModel& other : elsewhere) {
    result.posterior.others.push_back(posterior_of(other, levels, result.slip_force));
  }
  if (model.few_levels() && !model.lambda_fixed) {
    set_goals(model, levels, result.posterior);
    const DensityPosterior rough =
        hardly_smooth(model, posterior_of(model, levels, result.slip_force));
    result.posterior.others.insert(result.posterior.others.end(), kRoughChains, rough);
  }
  result.smoothing_trend = model.trend;
  for (const double s : model.basis().edges()) {
    result.edges.push_back(model.largest_slip_force() * s);
  }
}

}  // namespace microslip
