// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/possible_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/identify/posterior/density_posterior.hpp"
#include "microslip/identify/posterior/plain_matrix_view.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// −2 ln p of the coefficients above its minimum: of three deviations, and of 95 %.
constexpr double kThreeDeviations = 9.0;
constexpr double kNineteenOfTwenty = 3.841;
/// λ over the smallest of the path, and that of few levels.
constexpr double kHardlySmooth = 1e-3;
constexpr double kHardlySmoothOfFewest = 1e-8;
/// Steps of the weight of the goal until that is reached, and how near is near enough.
constexpr int kSteps = 8;
constexpr double kNear = 0.1;
/// The least ratio of two of them.
constexpr double kLeastStep = 0.3;
/// Added to the diagonal, over its mean: rounding.
constexpr double kRidge = 1e-13;

/// −ln p = ½xᵀHx − gᵀx of coefficients, and its extremes.
class PossibleCoefficients {
 public:
  explicit PossibleCoefficients(const InversionResult& result);

  /// x of the largest value of a goal, to first order about each solution on the way.
  /// @param gradient  of the goal at x. @param rise  of −2 ln p.
  template <typename Gradient>
  [[nodiscard]] Eigen::VectorXd extreme(const Gradient& gradient, double rise);

 private:
  void add(const PosteriorRows& rows, double scatter);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& more);
  [[nodiscard]] double value(const Eigen::VectorXd& x) const {
    return x.dot(hessian_ * x) - 2.0 * linear_.dot(x);
  }

  Eigen::MatrixXd hessian_;
  Eigen::VectorXd linear_;
  QuadraticProgram program_;
  std::vector<bool> free_;
};

PossibleCoefficients::PossibleCoefficients(const InversionResult& result)
    : program_(view_of(result.posterior.area), 1.0), free_(result.posterior.area.size(), true) {
  const DensityPosterior& posterior = result.posterior;
  const bool given = posterior.smoothing.least == posterior.smoothing.most;
  const double share = posterior.reaches_limits ? kHardlySmoothOfFewest : kHardlySmooth;
  const double lambda = given ? posterior.smoothing.chosen : share * posterior.smoothing.least;
  const auto penalty = matrix_of(posterior.penalty);
  hessian_ = lambda * penalty.transpose() * penalty;
  linear_.setZero(hessian_.cols());
  add(posterior.dissipation, posterior.scatter);
  if (posterior.secant.factor.rows() > 0) {
    add(posterior.secant, std::max(posterior.scatter, posterior.secant.least_scatter));
  }
  hessian_.diagonal().array() += kRidge * hessian_.diagonal().mean();
}

void PossibleCoefficients::add(const PosteriorRows& rows, double scatter) {
  const double precision = 1.0 / (scatter * scatter);
  const auto factor = matrix_of(rows.factor);
  hessian_ += precision * factor.transpose() * factor;
  linear_ += precision * factor.transpose() * view_of(rows.data);
}

Eigen::VectorXd PossibleCoefficients::solve(const Eigen::VectorXd& more) {
  QuadraticProgram::Solution solution = program_.solve(hessian_, linear_ + more, free_);
  free_ = solution.free;
  return std::move(solution.x);
}

// The weight of the goal beside −ln p is found from the rise of that: without limits it grows with
// the square.
template <typename Gradient>
Eigen::VectorXd PossibleCoefficients::extreme(const Gradient& gradient, double rise) {
  Eigen::VectorXd x = solve(Eigen::VectorXd::Zero(linear_.size()));
  const double least = value(x);
  const Eigen::LLT<Eigen::MatrixXd> factor(hessian_);
  const Eigen::VectorXd first = gradient(x);
  double weight = std::sqrt(rise / std::max(1e-300, first.dot(factor.solve(first))));
  for (int i = 0; i < kSteps; ++i) {
    Eigen::VectorXd tried = solve(weight * gradient(x));
    const double risen = value(tried) - least;
    if (risen <= (1.0 + kNear) * rise) x = std::move(tried);
    if (std::abs(risen / rise - 1.0) < kNear) break;
    weight *= std::clamp(std::sqrt(rise / std::max(risen, 1e-300)), kLeastStep, 1.0 / kLeastStep);
  }
  return x;
}

/// 1 − k_eq/k at two amplitudes, as rows of the coefficients.
Eigen::MatrixXd softening_of(const InversionResult& result, double stiffness, double from,
                             double to) {
  const DensityPosterior& posterior = result.posterior;
  const double force = stiffness * to;
  std::vector<double> knots;  // the first is 0, to where the density is constant
  for (std::size_t i = 1; i < posterior.slip_force.size(); ++i) {
    knots.push_back(posterior.slip_force[i] / force);
  }
  const Eigen::Vector2d amplitude(from / to, 1.0);
  const auto density = matrix_of(posterior.density);
  Eigen::MatrixXd rows =
      force * softening_rows(amplitude, knots) * density.bottomRows(density.rows() - 1);
  if (result.atom_slip_force) {
    rows += atom_softening(amplitude, *result.atom_slip_force / force) *
            view_of(posterior.atom_weight).transpose();
  }
  return rows;
}

/// Gradient of ½ ln(k_eq(A₁)/k_eq(A₂)).
Eigen::VectorXd gradient(const Eigen::MatrixXd& softening, const Eigen::VectorXd& x) {
  constexpr double kLeastStiffness = 1e-3;
  const Eigen::VectorXd left = (1.0 - (softening * x).array()).max(kLeastStiffness).matrix();
  return 0.5 * (softening.row(1) / left(1) - softening.row(0) / left(0)).transpose();
}

}  // namespace

Joint softest_joint(const InversionResult& result, double stiffness, double from, double to) {
  result.check();
  if (!(from > 0.0 && to > from)) {
    throw InputError("amplitude", from, "must be positive, and below the other");
  }
  const Eigen::MatrixXd softening = softening_of(result, stiffness, from, to);
  const Eigen::VectorXd x = PossibleCoefficients(result).extreme(
      [&](const Eigen::VectorXd& at) { return gradient(softening, at); }, kThreeDeviations);
  const Eigen::VectorXd at_knots = matrix_of(result.posterior.density) * x;
  InversionResult softest = result;
  softest.density.assign(at_knots.begin(), at_knots.end());
  softest.atom_weight = view_of(result.posterior.atom_weight).dot(x);
  return joint_of(softest, stiffness);
}

double least_area(const InversionResult& result) {
  result.check();
  const Eigen::VectorXd area = view_of(result.posterior.area);
  const Eigen::VectorXd downwards = -area;
  const Eigen::VectorXd x = PossibleCoefficients(result).extreme(
      [&](const Eigen::VectorXd&) { return downwards; }, kNineteenOfTwenty);
  return area.dot(x);
}

}  // namespace microslip
