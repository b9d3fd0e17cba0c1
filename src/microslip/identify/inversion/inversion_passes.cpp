// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_passes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "microslip/base/median.hpp"

namespace microslip {
namespace {

/// χ₀ stays where its power law has an area, and never rises: a rising reference would claim
/// that there is no density at small slip forces, which D hardly determines.
constexpr double kLeastExponent = -0.9;

/// More points than this do not improve a slope.
constexpr Eigen::Index kSlopePoints = 200;

constexpr double kMostOfGiven = 4.0;

/// χ₀: the median slope of ln d over ln a between levels far enough apart, less 3. [Theil & Sen]
double reference_exponent(const ScaledLevels& levels, const Eigen::VectorXd& d) {
  const Eigen::ArrayXd x = levels.amplitude.array().log();
  const Eigen::ArrayXd y =
      d.cwiseMax(1e-4 * d.maxCoeff() * levels.amplitude.array().cube().matrix()).array().log();
  const double range = x(x.size() - 1) - x(0);
  const Eigen::Index step = 1 + (x.size() - 1) / kSlopePoints;
  std::vector<double> slopes;
  for (Eigen::Index i = 0; i < x.size(); i += step) {
    for (Eigen::Index j = i + step; j < x.size(); j += step) {
      if (x(j) - x(i) > 0.3 * range) slopes.push_back((y(j) - y(i)) / (x(j) - x(i)));
    }
  }
  return std::clamp(median(std::move(slopes)) - 3.0, kLeastExponent, 0.0);
}

/// A density that leaves more than four times the deviations that were given is not chosen where
/// another of the path leaves less: where none of the low levels slips, the wide prior of a density
/// with a gap is less likely than a scatter of a hundred of them.
double most_residual(const InversionModel& model) {
  if (!model.deviations_given()) return std::numeric_limits<double>::infinity();
  const KnownScatter& known = model.known_scatter();
  const auto rows = static_cast<double>(model.problem().rows());
  double least = std::numeric_limits<double>::infinity();
  for (const SmoothingPoint& point : model.path) {
    if (point.edf > model.most_edf) continue;
    least = std::min(least, (point.residual + known.square) / (rows + known.freedom - point.edf));
  }
  return kMostOfGiven * kMostOfGiven * rows * std::max(1.0, least);
}

/// ω of each second difference: larger, up to 3 times, where an earlier pass found little density.
Eigen::VectorXd penalty_weights(const Eigen::VectorXd& theta) {
  const Eigen::Index n = theta.size();
  Eigen::VectorXd mean(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    double sum = 0.0;
    for (Eigen::Index j = i - 2; j <= i + 2; ++j) {
      sum += std::abs(theta(std::clamp<Eigen::Index>(j, 0, n - 1)));
    }
    mean(i) = sum / 5.0;
  }
  const double typical = std::max(1e-300, std::sqrt(mean.squaredNorm() / static_cast<double>(n)));
  Eigen::ArrayXd level = (mean.head(n - 2) + mean.segment(1, n - 2) + mean.tail(n - 2)) / 3.0;
  const Eigen::ArrayXd weight = (level / typical + 0.1).rsqrt();
  return (weight / std::exp(weight.log().mean())).matrix();
}

}  // namespace

PathScatter estimate_scatter(const InversionModel& model, double residual, double edf) {
  const double informative =
      std::max(static_cast<double>(model.problem().unpenalised()) + 1.0, model.informative_rows());
  const double rows = static_cast<double>(model.problem().rows());
  const KnownScatter& known = model.known_scatter();
  const double freedom =
      informative - std::min({edf, 0.8 * informative, rows - 1.0}) + known.freedom;
  return {std::sqrt((residual + known.square) / freedom), freedom};
}

void separate_scatter(InversionModel& model, const ScaledLevels& levels) {
  const SmoothingProblem& problem = model.problem();
  const Eigen::Index n = model.dissipation_rows();
  const Eigen::Index rest = problem.rows() - n;
  if (rest == 0) return;
  const SmoothingPoint& point = model.solution();
  const Eigen::VectorXd square = (problem.data() - problem.design() * point.solution.x).cwiseAbs2();
  const Eigen::VectorXd leverage = problem.leverage(point);
  const double both = std::max(model.scatter, 1e-150);  // levels of zero leave none
  const auto relative = [&](double residual, double edf, double rows, const KnownScatter& known) {
    const double informative = std::max(rows, 1.0);
    const double freedom = informative - std::min(edf, 0.8 * informative) + known.freedom;
    return std::sqrt((residual + known.square) / freedom) / both;
  };
  const double softening_rows = static_cast<double>(rest) - 1.0;  // less the offset
  model.dissipation_scatter =
      relative(square.head(n).sum(), leverage.head(n).sum(),
               model.informative_rows() - softening_rows, model.known_scatter());
  model.softening_scatter = relative(square.tail(rest).sum(), leverage.tail(rest).sum(),
                                     softening_rows, model.known_softening_scatter());
  model.least_softening_scatter = levels.evidence.secant_std_given() ? 1.0 / both : 0.0;
}

void run_path(InversionModel& model, const InversionOptions& options, std::size_t points,
              InnerSolutions& inner) {
  const SmoothingProblem& problem = model.problem();
  model.most_edf = problem.most_edf();
  std::vector<double> lambdas = problem.lambda_grid(points);
  if (options.lambda) {  // the path goes from stiff to flexible
    const auto after = std::ranges::find_if(lambdas, [&](double l) { return l < *options.lambda; });
    model.chosen = static_cast<std::size_t>(after - lambdas.begin());
    lambdas.insert(after, *options.lambda);
  }
  model.path = problem.path(lambdas);
  for (const SmoothingPoint& point : model.path) inner.add(point.solution);
  model.lambda_fixed = options.lambda.has_value();
  if (!model.lambda_fixed) {
    model.chosen = choose(model.path, options.rule, {model.most_edf, most_residual(model)});
  }
  const SmoothingPoint& point = model.solution();
  const PathScatter scatter = estimate_scatter(model, point.residual, point.edf);
  model.scatter = scatter.value;
  model.degrees_of_freedom = scatter.degrees_of_freedom;
}

PassedModel two_passes(const ScaledLevels& levels, const InversionOptions& options, double top,
                       bool atom, InnerSolutions& inner) {
  PassOptions pass;
  pass.top = top;
  pass.atom = atom;
  pass.linear_damping = options.linear_damping;
  pass.coefficients = options.coefficients;
  pass.fit = levels.typical;
  pass.exponent = reference_exponent(levels, levels.dissipation);
  InversionOptions automatic = options;
  automatic.lambda.reset();
  InversionModel first(levels, pass);
  run_path(first, automatic, kFirstPassPoints, inner);

  const Eigen::VectorXd& x = first.solution().solution.x;
  pass.fit = first.dissipation(x);
  pass.penalty_weights = penalty_weights(first.theta(x));
  if (options.linear_damping) {
    const Eigen::VectorXd damping = first.linear_damping(x) * levels.amplitude.cwiseAbs2();
    pass.exponent =
        reference_exponent(levels, (levels.dissipation - damping).cwiseMax(levels.floor));
  }
  InversionModel second(levels, pass);
  run_path(second, automatic, options.path_points, inner);
  separate_scatter(second, levels);
  return {std::move(pass), std::move(second)};
}

}  // namespace microslip
