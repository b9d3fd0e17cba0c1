// SPDX-License-Identifier: MIT
#include "microslip/identify/parametric/parametric_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>

namespace microslip {
namespace {

using Vector = std::vector<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Function = std::function<VectorXd(std::span<const double>)>;

std::vector<std::size_t> free_places(const std::vector<Hold>& hold) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < hold.size(); ++i) {
    if (hold[i] == Hold::kFree) places.push_back(i);
  }
  return places;
}

/// The face of the ranges on which some coordinates are fixed, over the u of the others.
class Face {
 public:
  Face(const LeastSquares& problem, std::vector<Hold> hold)
      : problem_(&problem), hold_(std::move(hold)), free_(free_places(hold_)) {}

  [[nodiscard]] Vector q(const VectorXd& u) const {
    Vector q(hold_.size());
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Coordinate& c = problem_->coordinates[i];
      q[i] = hold_[i] == Hold::kLower ? c.lower : c.upper;
    }
    for (std::size_t j = 0; j < free_.size(); ++j) {
      q[free_[j]] = problem_->coordinates[free_[j]].value(u[static_cast<Index>(j)]);
    }
    return q;
  }

  [[nodiscard]] VectorXd u(std::span<const double> q) const {
    VectorXd u(static_cast<Index>(free_.size()));
    for (std::size_t j = 0; j < free_.size(); ++j) {
      u[static_cast<Index>(j)] = problem_->coordinates[free_[j]].inverse(q[free_[j]]);
    }
    return u;
  }

  /// ∂f/∂u, by central differences: their step balances the h² of the method and rounding over h.
  [[nodiscard]] MatrixXd jacobian(const Function& f, const VectorXd& at) const {
    constexpr double kStep = 6e-6;  // ε^⅓
    MatrixXd result;
    VectorXd moved = at;
    for (Index j = 0; j < at.size(); ++j) {
      const double step = kStep * std::max(1.0, std::abs(at[j]));
      moved[j] = at[j] + step;
      const VectorXd above = f(q(moved));
      moved[j] = at[j] - step;
      const VectorXd below = f(q(moved));
      moved[j] = at[j];
      if (j == 0) result.resize(above.size(), at.size());
      result.col(j) = (above - below) / (2.0 * step);
    }
    return result;
  }

  [[nodiscard]] const std::vector<Hold>& hold() const { return hold_; }
  [[nodiscard]] const LeastSquares& problem() const { return *problem_; }

 private:
  const LeastSquares* problem_;
  std::vector<Hold> hold_;
  std::vector<std::size_t> free_;
};

/// The interface that Eigen's solver needs.
struct Functor {
  const Face* face;
  Index rows;

  [[nodiscard]] int values() const { return static_cast<int>(rows); }
  int operator()(const VectorXd& u, VectorXd& residuals) const {
    residuals = face->problem().residuals(face->q(u));
    return 0;
  }
  int df(const VectorXd& u, MatrixXd& jacobian) const {
    jacobian = face->jacobian(face->problem().residuals, u);
    return 0;
  }
};

Minimum follow(const Face& face, const Vector& start, int max_evaluations) {
  namespace lm = Eigen::LevenbergMarquardtSpace;
  VectorXd u = face.u(start);
  Minimum result{.q = face.q(u), .hold = face.hold()};
  const VectorXd first = face.problem().residuals(result.q);
  result.sum_of_squares = first.squaredNorm();
  if (u.size() == 0) {
    result.converged = true;
    return result;
  }
  Functor functor{&face, first.size()};
  Eigen::LevenbergMarquardt<Functor> solver(functor);
  solver.parameters.ftol = 1e-13;
  solver.parameters.xtol = 1e-10;
  solver.parameters.maxfev = max_evaluations;
  const lm::Status status = solver.minimize(u);
  result.q = face.q(u);
  result.sum_of_squares = face.problem().residuals(result.q).squaredNorm();
  result.converged =
      status != lm::TooManyFunctionEvaluation && status != lm::ImproperInputParameters;
  result.iterations = static_cast<int>(solver.iter);
  return result;
}

/// All combinations of free coordinates and admissible bounds, the all-free one first.
std::vector<std::vector<Hold>> faces(const std::vector<Coordinate>& coordinates) {
  std::vector<std::vector<Hold>> result{{}};
  for (const Coordinate& c : coordinates) {
    std::vector<std::vector<Hold>> longer;
    for (const Hold hold : {Hold::kFree, Hold::kLower, Hold::kUpper}) {
      if (hold == Hold::kLower && !c.lower_admitted) continue;
      if (hold == Hold::kUpper && !c.upper_admitted) continue;
      for (auto face : result) {
        face.push_back(hold);
        longer.push_back(std::move(face));
      }
    }
    result = std::move(longer);
  }
  return result;
}

std::vector<Vector> best_of(const LeastSquares& problem, const std::vector<Vector>& candidates,
                            int count) {
  std::vector<std::pair<double, const Vector*>> ranked;
  for (const Vector& q : candidates) {
    const double sum = problem.residuals(q).squaredNorm();
    ranked.emplace_back(std::isfinite(sum) ? sum : std::numeric_limits<double>::max(), &q);
  }
  std::ranges::stable_sort(ranked, {}, &std::pair<double, const Vector*>::first);
  std::vector<Vector> best;
  for (const auto& [sum, q] : ranked) {
    if (best.size() < static_cast<std::size_t>(count)) best.push_back(*q);
  }
  return best;
}

std::ptrdiff_t fixed_count(const Minimum& minimum) {
  return std::ranges::count_if(minimum.hold, [](Hold hold) { return hold != Hold::kFree; });
}

/// A smaller sum, or an equal one with more coordinates fixed.
bool better(const Minimum& a, const Minimum& b, double rounding) {
  constexpr double kEqual = 1e-9;
  const double tolerance = kEqual * std::min(a.sum_of_squares, b.sum_of_squares) + rounding;
  if (std::abs(a.sum_of_squares - b.sum_of_squares) > tolerance ||
      fixed_count(a) == fixed_count(b)) {
    return a.sum_of_squares < b.sum_of_squares;
  }
  return fixed_count(a) > fixed_count(b);
}

}  // namespace

std::vector<std::size_t> Minimum::free() const { return free_places(hold); }

Minimum minimise(const LeastSquares& problem, const std::vector<std::vector<double>>& candidates,
                 int starts, int max_evaluations) {
  const std::vector<Vector> from = best_of(problem, candidates, starts);
  std::vector<Minimum> found;
  for (const auto& hold : faces(problem.coordinates)) {
    const Face face(problem, hold);
    for (const Vector& start : from) found.push_back(follow(face, start, max_evaluations));
  }
  Minimum best = found.front();
  for (const Minimum& minimum : found) {
    if (better(minimum, best, problem.rounding)) best = minimum;
  }
  best.iterations = 0;
  best.starts = static_cast<int>(found.size());
  best.agreeing = 0;
  for (const Minimum& minimum : found) {
    const double excess = minimum.sum_of_squares - best.sum_of_squares;
    best.iterations += minimum.iterations;
    if (excess <= 1e-6 * best.sum_of_squares + problem.rounding) ++best.agreeing;
  }
  return best;
}

MatrixXd free_jacobian(const LeastSquares& problem, const Minimum& minimum) {
  return free_jacobian(problem, minimum, problem.residuals);
}

MatrixXd free_jacobian(const LeastSquares& problem, const Minimum& minimum, const Function& f) {
  const Face face(problem, minimum.hold);
  return face.jacobian(f, face.u(minimum.q));
}

}  // namespace microslip
