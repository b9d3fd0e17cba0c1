// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/possible_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/algebra/cholesky.hpp"

namespace microslip {
namespace {

/// Steps of the weight of the goal until that is reached, and how near is near enough.
constexpr int kGoalSteps = 25;
constexpr double kNearGoal = 0.1;
/// The least ratio of two of them.
constexpr double kLeastStep = 0.1;
/// Added to the diagonal, over its mean: rounding.
constexpr double kPossibleRidge = 1e-13;

}  // namespace

PossibleCoefficients::PossibleCoefficients(const Eigen::MatrixXd& penalty, double lambda,
                                           Eigen::VectorXd area)
    : hessian_(lambda * penalty.transpose() * penalty),
      linear_(Eigen::VectorXd::Zero(area.size())),
      area_(std::move(area)),
      program_(area_, 1.0),
      free_(static_cast<std::size_t>(area_.size()), true) {}

void PossibleCoefficients::add(const Eigen::MatrixXd& factor, const Eigen::VectorXd& data,
                               double scatter) {
  const double precision = 1.0 / (scatter * scatter);
  hessian_ += precision * factor.transpose() * factor;
  linear_ += precision * factor.transpose() * data;
}

Eigen::VectorXd PossibleCoefficients::solve(const Eigen::MatrixXd& hessian,
                                            const Eigen::VectorXd& more) {
  QuadraticProgram::Solution solution = program_.solve(hessian, linear_ + more, free_);
  free_ = solution.free;
  return std::move(solution.x);
}

// The weight of the goal beside −ln p is found from the rise of that: without limits it grows with
// the square.
Eigen::VectorXd PossibleCoefficients::extreme(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& gradient, double rise) {
  Eigen::MatrixXd hessian = hessian_;
  hessian.diagonal().array() += kPossibleRidge * hessian.diagonal().mean();
  const auto value = [&](const Eigen::VectorXd& x) {
    return x.dot(hessian * x) - 2.0 * linear_.dot(x);
  };
  Eigen::VectorXd x = solve(hessian, Eigen::VectorXd::Zero(linear_.size()));
  const double least = value(x);
  const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
  const Eigen::VectorXd first = gradient(x);
  double weight = std::sqrt(rise / std::max(1e-300, first.dot(factor.solve(first))));
  for (int i = 0; i < kGoalSteps; ++i) {
    Eigen::VectorXd tried = solve(hessian, weight * gradient(x));
    const double risen = value(tried) - least;
    if (risen <= (1.0 + kNearGoal) * rise) x = std::move(tried);
    if (std::abs(risen / rise - 1.0) < kNearGoal) break;
    weight *= std::clamp(std::sqrt(rise / std::max(risen, 1e-300)), kLeastStep, 1.0 / kLeastStep);
  }
  return x / std::max(1.0, area_.dot(x));  // rounding
}

}  // namespace microslip
