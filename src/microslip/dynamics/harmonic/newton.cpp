// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/newton.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "microslip/dynamics/harmonic/bordered_factors.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kRounding = 1e-10;     // residuals this small may be the rounding of the equations
constexpr double kLargestChange = 0.3;  // of ω in one step, relative

/// One of the two equations in addition to the balance.
struct Condition {
  std::function<double(const VectorXd& z)> miss;
  std::function<Eigen::RowVectorXd()> gradient;
};

class Newton {
 public:
  Newton(BalanceEquations& equations, Condition first, Condition second, BorderedFactors& factors)
      : equations_(equations),
        first_(std::move(first)),
        second_(std::move(second)),
        factors_(factors) {}

  NewtonResult run(const NewtonOptions& options, VectorXd& z) {
    NewtonResult result = iterate(options, z);
    if (result.converged && !(z[equations_.balance_count() + 1] > 0.0)) {
      result.converged = false;
      result.reason = "the force amplitude became negative";
    }
    if (!result.converged) {
      z = best_;
      equations_.evaluate(z);
    }
    return result;
  }

 private:
  NewtonResult iterate(const NewtonOptions& options, VectorXd& z) {
    NewtonResult result;
    double residual = evaluate(z);
    best_ = z;
    result.residual = residual;
    for (result.iterations = 1; result.iterations < options.max_iterations; ++result.iterations) {
      if (residual == HUGE_VAL) {
        result.reason =
            "the equations are not finite: an undamped mode at its pole, restrained by no joint";
        return result;
      }
      result.converged = residual <= options.tolerance;
      if (result.converged) {
        result.reason = "residual below the tolerance";
        return result;
      }
      const VectorXd step = this->step(result);
      if (!step.allFinite()) {
        result.reason = "the equations have no finite step";
        return result;
      }
      const double next = advance(step, residual, z, result.iterations);
      keep_ = factors_.are_costly() && serves_on(residual, next, options.tolerance);
      if (next < result.residual) {
        result.residual = next;
        best_ = z;
      }
      if (residual <= kRounding && !(next < 0.5 * residual)) {
        result.converged = next <= kRounding;
        result.reason = "residual down to rounding";
        return result;
      }
      residual = next;
    }
    result.converged = residual <= options.tolerance;
    result.reason =
        result.converged ? "residual below the tolerance" : "the iteration limit was reached";
    return result;
  }

  /// The scaled equations at z; returns the largest residual.
  double evaluate(const VectorXd& z) {
    equations_.evaluate(z);
    const Index n = equations_.balance_count();
    scale_ = equations_.scale();
    residual_.resize(n + 2);
    residual_.head(n) = equations_.residual().cwiseQuotient(scale_.head(n));
    residual_.tail(2) << first_.miss(z), second_.miss(z);
    return residual_.allFinite() ? residual_.cwiseAbs().maxCoeff() : HUGE_VAL;
  }

  /// Whether the factors of the last step also suffice from its residual to the tolerance: a
  /// residual falls by the same factor from step to step, or, of the first step, which Newton's
  /// method makes fall faster, by less.
  static bool serves_on(double before, double after, double tolerance) {
    constexpr double kMostSteps = 4.0;
    return after > 0.0 && std::log(tolerance / after) >= kMostSteps * std::log(after / before);
  }

  /// Relative to the scale of the factors; from where the equations were evaluated last.
  [[nodiscard]] VectorXd step(NewtonResult& result) {
    if (keep_) {
      ++result.kept;
      const Index n = equations_.balance_count();
      VectorXd right = -residual_;
      right.head(n).array() *= scale_.head(n).array() / scale_of_factors_.head(n).array();
      return factors_.solve(right);
    }
    scale_of_factors_ = scale_;
    factors_.compute(equations_, scale_, first_.gradient() * scale_.asDiagonal(),
                     second_.gradient() * scale_.asDiagonal());
    return factors_.solve(-residual_);
  }

  /// Takes the step, or the part of it that does not increase the error. The error is judged by the
  /// next step with the matrix of this one (natural monotonicity test [Deuflhard]), and not by the
  /// residual: close to a resonance a small error of frequency turns the phase of all motion, and
  /// the residual grows towards the solution.
  double advance(const VectorXd& step, double residual, VectorXd& z, int& evaluations) {
    const Index frequency = equations_.balance_count();
    const VectorXd change = scale_of_factors_.cwiseProduct(step);
    double share = std::min(1.0, kLargestChange * z[frequency] / std::abs(change[frequency]));
    const VectorXd start = z;
    double next = HUGE_VAL;
    for (int halving = 0; halving <= 4; ++halving, share *= 0.5) {
      z = start + share * change;
      next = evaluate(z);
      if (next < residual || residual <= kRounding) break;
      if (std::isfinite(next) && factors_.solve(residual_).norm() < step.norm()) break;
      ++evaluations;
    }
    return next;
  }

  BalanceEquations& equations_;
  Condition first_;
  Condition second_;
  VectorXd scale_;
  VectorXd residual_;
  BorderedFactors& factors_;  // where the step starts, or of a step before
  bool keep_ = false;         // those of the step before
  VectorXd scale_of_factors_;
  VectorXd best_;  // z of the smallest residual
};

Condition condition(BalanceEquations& equations, const Target& target) {
  return {[&equations, target](const VectorXd&) { return equations.miss(target); },
          [&equations, target] { return equations.miss_gradient(target); }};
}

Condition condition(BalanceEquations& equations, const Onset& onset) {
  return {[&equations, onset](const VectorXd&) { return equations.miss(onset); },
          [&equations, onset] { return equations.miss_gradient(onset); }};
}

Condition condition(BalanceEquations& equations, const Tie& tie) {
  return {[&equations, tie](const VectorXd&) { return equations.miss(tie); },
          [&equations, tie] { return equations.miss_gradient(tie); }};
}

Condition condition(const Place& place) {
  return {[&place](const VectorXd& z) { return place.normal * (z - place.at); },
          [&place] { return place.normal; }};
}

}  // namespace

NewtonResult newton(BalanceEquations& equations, const Target& first, const Target& second,
                    const NewtonOptions& options, VectorXd& z, BorderedFactors& factors) {
  return Newton(equations, condition(equations, first), condition(equations, second), factors)
      .run(options, z);
}

NewtonResult newton(BalanceEquations& equations, const Target& first, const Place& second,
                    const NewtonOptions& options, VectorXd& z, BorderedFactors& factors) {
  return Newton(equations, condition(equations, first), condition(second), factors).run(options, z);
}

NewtonResult newton(BalanceEquations& equations, const Target& first, const Onset& second,
                    const NewtonOptions& options, VectorXd& z, BorderedFactors& factors) {
  return Newton(equations, condition(equations, first), condition(equations, second), factors)
      .run(options, z);
}

NewtonResult newton(BalanceEquations& equations, const Target& first, const Tie& second,
                    const NewtonOptions& options, VectorXd& z, BorderedFactors& factors) {
  return Newton(equations, condition(equations, first), condition(equations, second), factors)
      .run(options, z);
}

NewtonResult newton(BalanceEquations& equations, const Target& first, const Target& second,
                    const NewtonOptions& options, VectorXd& z) {
  BorderedFactors factors;
  return newton(equations, first, second, options, z, factors);
}

NewtonResult newton(BalanceEquations& equations, const Target& first, const Place& second,
                    const NewtonOptions& options, VectorXd& z) {
  BorderedFactors factors;
  return newton(equations, first, second, options, z, factors);
}

}  // namespace microslip
