// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/quadratic_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "microslip/algebra/cholesky.hpp"

namespace microslip {
namespace {

constexpr double kPrimalTolerance = 1e-12;
constexpr double kDualTolerance = 1e-10;
/// Rounding relative to the sum of |H_ij x_j|: a dozen of them or so are as large as the largest,
/// and so is the backward error of the factorisation.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
constexpr int kBlockTrials = 4;  // block exchanges without progress before go_downhill()
constexpr int kMostExchanges = 2000;

/// The lower triangle of the rows and columns of an index, which rises.
void take_lower(const Eigen::MatrixXd& matrix, const std::vector<Eigen::Index>& index,
                Eigen::MatrixXd& taken) {
  const std::size_t count = index.size();
  taken.resize(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  for (std::size_t j = 0; j < count; ++j) {
    const double* from = matrix.col(index[j]).data();
    double* to = taken.col(static_cast<Eigen::Index>(j)).data();
    for (std::size_t i = j; i < count; ++i) to[i] = from[index[i]];
  }
}

}  // namespace

QuadraticProgram::QuadraticProgram(Eigen::VectorXd budget_weights, double budget)
    : budget_weights_(std::move(budget_weights)), budget_(budget) {}

// On the free variables Hx + μm = g: x = a − μb with Ha = g, Hb = m, and μ = (mᵀa − budget)/(mᵀb)
// where that is positive, else 0. False where H is not positive definite to rounding.
bool QuadraticProgram::solve_on_free(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                     Solution& solution) {
  const Eigen::Index n = linear.size();
  index_.clear();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (solution.free[static_cast<std::size_t>(i)]) index_.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(index_.size());
  solution.x.setZero(n);
  solution.multiplier = 0.0;
  if (count > 0) {
    take_lower(hessian, index_, reduced_);
    right_.resize(count, 2);
    right_.col(0) = linear(index_);
    right_.col(1) = budget_weights_(index_);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(reduced_);
    if (factor.info() != Eigen::Success) {
      slack_.setConstant(n, std::numeric_limits<double>::infinity());
      slack_rounding_ = 0.0;
      return false;
    }
    factor.matrixL().solveInPlace(right_);
    const double spent = right_.col(0).dot(right_.col(1));
    const double price = right_.col(1).squaredNorm();
    if (spent > budget_ && price > 0.0) solution.multiplier = (spent - budget_) / price;
    right_.col(0) -= solution.multiplier * right_.col(1);
    auto x = right_.col(0);
    factor.matrixU().solveInPlace(x);
    for (Eigen::Index i = 0; i < count; ++i) solution.x(index_[static_cast<std::size_t>(i)]) = x(i);
  }
  slack_.noalias() = hessian.selfadjointView<Eigen::Lower>() * solution.x;
  slack_ += solution.multiplier * budget_weights_ - linear;
  magnitude_.setZero(n);
  for (const Eigen::Index j : index_) {
    magnitude_ += hessian.col(j).cwiseAbs() * std::abs(solution.x(j));
  }
  slack_rounding_ = kRounding * magnitude_.maxCoeff();
  return true;
}

// In extended precision: with strong smoothing Hx is a small difference of large numbers, and its
// rounding in double precision is no violation.
double QuadraticProgram::kkt_residual(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                      const Solution& solution) const {
  const double gradient_scale = std::max(linear.cwiseAbs().maxCoeff(), 1e-300);
  const double x_scale = std::max(solution.x.cwiseAbs().maxCoeff(), 1e-300);
  double worst = (budget_weights_.dot(solution.x) - budget_) / budget_;
  worst = std::max({worst, 0.0, -solution.x.minCoeff() / x_scale});
  for (Eigen::Index i = 0; i < linear.size(); ++i) {
    long double slack =
        static_cast<long double>(solution.multiplier) * budget_weights_(i) - linear(i);
    for (Eigen::Index j = 0; j < linear.size(); ++j) {
      slack += static_cast<long double>(hessian(j, i)) * solution.x(j);
    }
    const bool free = solution.free[static_cast<std::size_t>(i)];
    const auto wrong = static_cast<double>(free ? std::abs(slack) : -slack);
    worst = std::max(worst, wrong / gradient_scale);
  }
  return worst;
}

bool QuadraticProgram::pivot_blocks(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                    Solution& solution) {
  const auto n = static_cast<std::size_t>(linear.size());
  const double gradient_scale = linear.cwiseAbs().maxCoeff();
  std::size_t fewest = n + 1;
  std::vector<std::size_t> wrong;
  for (int trials = kBlockTrials; trials > 0; ++solution.exchanges) {
    if (!solve_on_free(hessian, linear, solution)) return false;
    const double primal_tolerance = kPrimalTolerance * solution.x.cwiseAbs().maxCoeff();
    const double dual_tolerance = kDualTolerance * gradient_scale + slack_rounding_;
    wrong.clear();
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const bool bad =
          solution.free[i] ? solution.x(row) < -primal_tolerance : slack_(row) < -dual_tolerance;
      if (bad) wrong.push_back(i);
    }
    if (wrong.empty()) return true;
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      trials = kBlockTrials;
    } else {
      --trials;
    }
    for (const std::size_t i : wrong) solution.free[i] = !solution.free[i];
  }
  return false;
}

// The method of [Lawson & Hanson, Solving Least Squares Problems, 1974, ch. 23] with the budget
// inside of the problem on the free variables: from a feasible x towards the minimiser on its free
// variables as far as all stay positive, until there; then the variable that promises most is
// freed. Each such minimiser lies below the one before, so no set of free variables returns.
bool QuadraticProgram::go_downhill(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                   Solution& solution) {
  const Eigen::Index n = linear.size();
  const double gradient_scale = linear.cwiseAbs().maxCoeff();
  Eigen::VectorXd x = solution.x.cwiseMax(0.0);
  const double spent = budget_weights_.dot(x);
  if (spent > budget_) x *= budget_ / spent;
  for (Eigen::Index i = 0; i < n; ++i) solution.free[static_cast<std::size_t>(i)] = x(i) > 0.0;
  for (; solution.exchanges < kMostExchanges; ++solution.exchanges) {
    if (!solve_on_free(hessian, linear, solution)) return false;
    const double primal_tolerance = kPrimalTolerance * solution.x.cwiseAbs().maxCoeff();
    double step = 1.0;
    Eigen::Index first = -1;  // to reach 0
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!(solution.x(i) < -primal_tolerance)) continue;
      const double share = x(i) / (x(i) - solution.x(i));
      if (first < 0 || share < step) {
        step = share;
        first = i;
      }
    }
    if (first >= 0) {
      x = (x + step * (solution.x - x)).cwiseMax(0.0);
      x(first) = 0.0;
      solution.free[static_cast<std::size_t>(first)] = false;
      continue;
    }
    x = solution.x.cwiseMax(0.0);
    Eigen::Index most = -1;
    double lowest = -(kDualTolerance * gradient_scale + slack_rounding_);
    for (Eigen::Index i = 0; i < n; ++i) {
      if (solution.free[static_cast<std::size_t>(i)] || slack_(i) >= lowest) continue;
      lowest = slack_(i);
      most = i;
    }
    if (most < 0) return true;
    solution.free[static_cast<std::size_t>(most)] = true;
  }
  return false;
}

QuadraticProgram::Solution QuadraticProgram::solve(const Eigen::MatrixXd& hessian,
                                                   const Eigen::VectorXd& linear,
                                                   std::vector<bool> start) {
  Solution solution;
  solution.free = std::move(start);
  solution.x.setZero(linear.size());
  slack_ = -linear;
  slack_rounding_ = 0.0;
  solution.converged =
      pivot_blocks(hessian, linear, solution) || go_downhill(hessian, linear, solution);
  if (!solution.x.allFinite()) {  // comparisons with it find nothing wrong
    solution.converged = false;
    solution.x.setZero();
  }
  solution.rounding = slack_rounding_ / std::max(linear.cwiseAbs().maxCoeff(), 1e-300);
  solution.kkt_residual = kkt_residual(hessian, linear, solution);
  solution.x = solution.x.cwiseMax(0.0);
  return solution;
}

void read_optimality(const QuadraticProgram::Solution& solution, std::string_view what,
                     Summary& summary) {
  constexpr double kWanted = QuadraticProgram::kMostKktResidual;
  const bool solved = solution.optimal();
  summary.residual = solution.kkt_residual;
  summary.stop = solved ? Stop::kConverged : Stop::kNoProgress;
  summary.reason = solved ? fmt::format("{} hold to {:.0e} or rounding", what, kWanted)
                          : fmt::format("{} hold to {:.0e} only, {:.0e} wanted", what,
                                        solution.kkt_residual, kWanted);
}

std::vector<Eigen::Index> free_coefficients(const QuadraticProgram::Solution& solution) {
  std::vector<Eigen::Index> index;
  for (std::size_t i = 0; i < solution.free.size(); ++i) {
    if (solution.free[i]) index.push_back(static_cast<Eigen::Index>(i));
  }
  return index;
}

}  // namespace microslip
