// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/quadratic_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/random.hpp"

namespace microslip::quadratic_program_test {
namespace {

struct Problem {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd linear;
  Eigen::VectorXd weights;
  double budget;
};

/// H = BᵀB + a little of I, of n rows in B; g of both signs; m in [0, 1], some of it 0.
Problem random_problem(Eigen::Index n, std::uint64_t seed, double budget) {
  RandomStream random(seed, static_cast<std::uint64_t>(n));
  Eigen::MatrixXd b(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) b(i, j) = random.normal();
  }
  Problem problem{b.transpose() * b, Eigen::VectorXd(n), Eigen::VectorXd(n), budget};
  problem.hessian.diagonal().array() += 0.05;
  for (double& value : problem.linear) value = 3.0 * random.normal();
  for (double& value : problem.weights) value = std::max(0.0, random.uniform() - 0.1);
  return problem;
}

std::vector<bool> all_free(const Problem& problem) {
  return std::vector<bool>(static_cast<std::size_t>(problem.linear.size()), true);
}

QuadraticProgram::Solution solve(const Problem& problem, const std::vector<bool>& start) {
  QuadraticProgram program(problem.weights, problem.budget);
  return program.solve(problem.hessian, problem.linear, start);
}

/// The largest violation of (KKT) in long double, on the scale of ‖g‖∞ for the gradient,
/// ‖x‖∞ for x and the budget for itself. Written from the conditions, not from the solver:
/// complementarity and the signs, no set of free variables. The effect of rounding x to doubles on
/// Hx is no violation.
double kkt_violation(const Problem& problem, const QuadraticProgram::Solution& solution) {
  const auto n = problem.linear.size();
  const double g_scale = problem.linear.cwiseAbs().maxCoeff();
  const double x_scale = std::max(1e-300, solution.x.cwiseAbs().maxCoeff());
  long double spent = 0.0L;
  long double worst = solution.multiplier < 0.0 ? 1.0L : 0.0L;
  for (Eigen::Index i = 0; i < n; ++i) {
    long double slack = static_cast<long double>(solution.multiplier) * problem.weights(i) -
                        static_cast<long double>(problem.linear(i));
    long double terms = 0.0L;
    for (Eigen::Index j = 0; j < n; ++j) {
      const long double term = static_cast<long double>(problem.hessian(i, j)) * solution.x(j);
      slack += term;
      terms += std::abs(term);
    }
    const long double rounding = 32.0L * std::numeric_limits<double>::epsilon() * terms;
    worst = std::max(worst, (-slack - rounding) / g_scale);
    worst = std::max(worst, -static_cast<long double>(solution.x(i)) / x_scale);
    if (solution.x(i) > 1e-12 * x_scale) {
      worst = std::max(worst, (std::abs(slack) - rounding) / g_scale);
    }
    spent += static_cast<long double>(problem.weights(i)) * solution.x(i);
  }
  worst = std::max(worst, (spent - problem.budget) / problem.budget);
  if (solution.multiplier > 1e-12 * g_scale) {
    worst = std::max(worst, (problem.budget - spent) / problem.budget);
  }
  return static_cast<double>(worst);
}

/// The minimiser by trying all sets of free variables, with the budget met and with it left alone:
/// the feasible stationary point of the lowest objective.
Eigen::VectorXd by_enumeration(const Problem& problem) {
  const auto n = static_cast<std::size_t>(problem.linear.size());
  Eigen::VectorXd best = Eigen::VectorXd::Zero(problem.linear.size());
  double lowest = 0.0;  // that of x = 0
  for (std::size_t set = 1; set < (std::size_t{1} << n); ++set) {
    std::vector<Eigen::Index> index;
    for (std::size_t i = 0; i < n; ++i) {
      if ((set >> i) % 2 == 1) index.push_back(static_cast<Eigen::Index>(i));
    }
    const Eigen::MatrixXd h = problem.hessian(index, index);
    const Eigen::VectorXd m = problem.weights(index);
    const Eigen::VectorXd a = h.ldlt().solve(problem.linear(index));
    const Eigen::VectorXd b = h.ldlt().solve(m);
    for (const bool met : {false, true}) {
      if (met && m.dot(b) <= 0.0) continue;
      const double multiplier = met ? (m.dot(a) - problem.budget) / m.dot(b) : 0.0;
      const Eigen::VectorXd part = a - multiplier * b;
      if (part.minCoeff() < 0.0 || m.dot(part) > problem.budget * (1.0 + 1e-12)) continue;
      Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.linear.size());
      x(index) = part;
      const double objective = 0.5 * x.dot(problem.hessian * x) - problem.linear.dot(x);
      if (objective < lowest) {
        lowest = objective;
        best = x;
      }
    }
  }
  return best;
}

/// Coordinate descent for a given multiplier, and bisection for the multiplier that meets the
/// budget.
Eigen::VectorXd by_coordinate_descent(const Problem& problem) {
  const auto n = problem.linear.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  const auto descend = [&](double multiplier) {
    for (int sweep = 0; sweep < 200000; ++sweep) {
      double moved = 0.0;
      for (Eigen::Index i = 0; i < n; ++i) {
        const double gradient =
            problem.hessian.col(i).dot(x) - problem.linear(i) + multiplier * problem.weights(i);
        const double next = std::max(0.0, x(i) - gradient / problem.hessian(i, i));
        moved = std::max(moved, std::abs(next - x(i)));
        x(i) = next;
      }
      if (moved <= 1e-14 * (1.0 + x.maxCoeff())) break;
    }
    return problem.weights.dot(x) - problem.budget;
  };
  if (descend(0.0) <= 0.0) return x;
  double low = 0.0;
  double high = 1.0;
  while (descend(high) > 0.0) high *= 2.0;
  for (int i = 0; i < 55; ++i) {
    const double middle = 0.5 * (low + high);
    (descend(middle) > 0.0 ? low : high) = middle;
  }
  return x;
}

// The reference tries every set of free variables, so it cannot miss the minimum; both solve the
// same small systems of condition below 1e4, to 1e−12 of x each. A budget of 0.3 mostly binds with
// these g, one of 1e3 never does.
TEST(QuadraticProgram, AgreesWithEnumerationOfAllSets) {
  int bound = 0;
  for (const double budget : {0.3, 2.0, 1e3}) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Problem problem = random_problem(1 + static_cast<Eigen::Index>(seed % 8), seed, budget);
      const auto solution = solve(problem, all_free(problem));
      const Eigen::VectorXd expected = by_enumeration(problem);
      EXPECT_TRUE(solution.converged);
      EXPECT_LT((solution.x - expected).cwiseAbs().maxCoeff(), 1e-10 * (1.0 + expected.maxCoeff()))
          << "seed " << seed << ", budget " << budget;
      EXPECT_LT(kkt_violation(problem, solution), 1e-10);
      EXPECT_LT(solution.kkt_residual, 1e-10);
      bound += solution.multiplier > 0.0 ? 1 : 0;
      if (budget == 1e3) {
        EXPECT_EQ(solution.multiplier, 0.0);
      }
    }
  }
  EXPECT_GT(bound, 40);  // both kinds of the budget were there
}

// Coordinate descent to 1e−14 a step is slow and shares nothing with the solver. Its error is that
// of the last step times the condition, here about 1e4.
TEST(QuadraticProgram, AgreesWithCoordinateDescent) {
  for (const double budget : {1.0, 1e3}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Problem problem = random_problem(24, 100 + seed, budget);
      const auto solution = solve(problem, all_free(problem));
      const Eigen::VectorXd expected = by_coordinate_descent(problem);
      EXPECT_LT((solution.x - expected).cwiseAbs().maxCoeff(), 1e-8 * (1.0 + expected.maxCoeff()))
          << "seed " << seed << ", budget " << budget;
      EXPECT_LT(kkt_violation(problem, solution), 1e-10);
    }
  }
}

// The minimiser is unique: whatever set one starts from, the answer is the same to rounding (1e−12
// of the largest x, the tolerance on its sign).
TEST(QuadraticProgram, StartDoesNotMatter) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Problem problem = random_problem(40, 200 + seed, seed % 2 == 0 ? 0.5 : 50.0);
    const auto cold = solve(problem, all_free(problem));
    RandomStream random(seed, 7);
    std::vector<bool> start;
    for (Eigen::Index i = 0; i < problem.linear.size(); ++i)
      start.push_back(random.uniform() < 0.5);
    for (const std::vector<bool>& from :
         {start, cold.free, std::vector<bool>(start.size(), false)}) {
      const auto warm = solve(problem, from);
      ASSERT_TRUE(warm.converged);
      EXPECT_LT((warm.x - cold.x).cwiseAbs().maxCoeff(), 1e-10 * (1.0 + cold.x.maxCoeff()));
    }
    EXPECT_EQ(solve(problem, cold.free).exchanges, 0);
  }
}

// With g ≤ 0 every direction into x ≥ 0 goes uphill, so x = 0 exactly.
TEST(QuadraticProgram, NothingPullsAwayFromZero) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Problem problem = random_problem(12, 300 + seed, 1.0);
    problem.linear = -problem.linear.cwiseAbs();
    const auto solution = solve(problem, all_free(problem));
    EXPECT_TRUE(solution.converged);
    EXPECT_EQ(solution.x.cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ(solution.multiplier, 0.0);
    problem.linear.setZero();
    EXPECT_EQ(solve(problem, all_free(problem)).x.cwiseAbs().maxCoeff(), 0.0);
  }
}

// A budget without weights limits nothing.
TEST(QuadraticProgram, WeightsOfZero) {
  Problem problem = random_problem(8, 5, 1e-6);
  problem.weights.setZero();
  const auto solution = solve(problem, all_free(problem));
  problem.budget = 1e9;
  EXPECT_EQ(solution.multiplier, 0.0);
  EXPECT_LT((solution.x - by_enumeration(problem)).cwiseAbs().maxCoeff(), 1e-10);
}

// Stiff smoothing: λLᵀL is ten orders above the data's part, so that the rounding of Hx alone is
// far above 1e−10 of ‖g‖. That is no reason to exchange variables for ever, nor to call it not
// converged.
TEST(QuadraticProgram, StiffSmoothingConverges) {
  constexpr Eigen::Index kSize = 120;
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(kSize - 2, kSize);
  for (Eigen::Index i = 0; i < kSize - 2; ++i) {
    second(i, i) = second(i, i + 2) = 1.0;
    second(i, i + 1) = -2.0;
  }
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Problem problem = random_problem(kSize, 400 + seed, 5.0);
    problem.hessian /= static_cast<double>(kSize);
    problem.hessian += 1e9 * second.transpose() * second;
    problem.linear.array() += 3.0;
    const auto solution = solve(problem, all_free(problem));
    EXPECT_TRUE(solution.converged);
    EXPECT_LT(solution.exchanges, 500);
    EXPECT_LT(kkt_violation(problem, solution), 1e-9);
  }
}

// Many almost parallel columns and a budget that binds: exchanging all wrong variables at once
// cycles here, so the descent has to end it.
TEST(QuadraticProgram, NearlyParallelColumnsConverge) {
  constexpr Eigen::Index kSize = 80;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(500 + seed, 0);
    Eigen::MatrixXd kernel(60, kSize);
    for (Eigen::Index j = 0; j < kSize; ++j) {
      const double s = (static_cast<double>(j) + 1.0) / kSize;
      for (Eigen::Index i = 0; i < kernel.rows(); ++i) {
        const double a = (static_cast<double>(i) + 1.0) / static_cast<double>(kernel.rows());
        kernel(i, j) = std::max(0.0, 4.0 * s * (a - s)) / (a * a * a) / kSize;
      }
    }
    Eigen::VectorXd data = kernel * Eigen::VectorXd::Ones(kSize);
    for (double& value : data) value *= 1.0 + 0.05 * random.normal();
    Problem problem{kernel.transpose() * kernel, kernel.transpose() * data,
                    Eigen::VectorXd::Constant(kSize, 1.0 / kSize), 1.0};
    problem.hessian.diagonal().array() += 1e-13 * problem.hessian.trace() / kSize;
    const auto solution = solve(problem, all_free(problem));
    EXPECT_TRUE(solution.converged);
    EXPECT_LT(kkt_violation(problem, solution), 1e-9);
  }
}

// A Hessian that is not positive definite breaks the contract. The result must state it, not be
// NaN.
TEST(QuadraticProgram, IndefiniteHessianIsReported) {
  Problem problem = random_problem(4, 9, 1.0);
  problem.hessian = -Eigen::MatrixXd::Identity(4, 4);
  problem.linear.setOnes();
  const auto solution = solve(problem, all_free(problem));
  EXPECT_FALSE(solution.converged);
  EXPECT_TRUE(solution.x.allFinite());
  EXPECT_GT(solution.kkt_residual, 1e-9);
}

}  // namespace
}  // namespace microslip::quadratic_program_test
