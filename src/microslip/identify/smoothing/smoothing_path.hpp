// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"
#include "microslip/identify/smoothing/smoothing_rule.hpp"

/// @file
/// The constrained smoothing problem over the smoothing parameter λ. Internal: Eigen stays out of
/// the installed headers.

namespace microslip {

/// What is known of the scatter beside the rows, as if by so many further rows whose residual does
/// not depend on the coefficients.
struct KnownScatter {
  double square = 0.0;   ///< their squared residual, in units of 1/W
  double freedom = 0.0;  ///< their number
};

/// A solution for one λ.
struct SmoothingPoint {
  double lambda = 0.0;     ///< 1
  double edf = 0.0;        ///< effective degrees of freedom, on the free coefficients
  double residual = 0.0;   ///< ‖W(Kθ − d)‖²
  double roughness = 0.0;  ///< ‖Lθ‖²
  double gcv = 0.0;        ///< generalised cross-validation score; infinite where edf is too high
  /// −2 log restricted likelihood, up to a constant; of path() and solve_unlimited() alone
  double likelihood = 0.0;
  QuadraticProgram::Solution solution;
};

/// minimise ½‖W(Kθ − d)‖² + ½λ‖Lθ‖²  subject to  θ ≥ 0, mᵀθ ≤ 1, for any λ > 0.
class SmoothingProblem {
 public:
  /// @param design       WK: rows × coefficients.
  /// @param data         Wd: one per row.
  /// @param penalty      L: penalty rows × coefficients.
  /// @param area         m: one per coefficient.
  /// @param unpenalised  q, dimension of the null space of L.
  /// @param known        of the scatter; it counts in the scores of a point.
  SmoothingProblem(Eigen::MatrixXd design, Eigen::VectorXd data, Eigen::MatrixXd penalty,
                   Eigen::VectorXd area, Eigen::Index unpenalised, KnownScatter known = {});

  [[nodiscard]] const Eigen::MatrixXd& design() const { return design_; }
  [[nodiscard]] const Eigen::VectorXd& data() const { return data_; }
  [[nodiscard]] const Eigen::MatrixXd& penalty() const { return penalty_; }
  [[nodiscard]] const Eigen::VectorXd& area() const { return area_; }
  [[nodiscard]] const Eigen::VectorXd& linear() const { return linear_; }
  [[nodiscard]] Eigen::Index rows() const { return data_.size(); }
  [[nodiscard]] Eigen::Index size() const { return linear_.size(); }
  [[nodiscard]] Eigen::Index unpenalised() const { return unpenalised_; }
  [[nodiscard]] const KnownScatter& known_scatter() const { return known_; }

  /// Degrees of freedom above which a solution is not supported by the rows and the scatter known.
  [[nodiscard]] double most_edf() const;

  /// WKᵀWK + λLᵀL.
  [[nodiscard]] Eigen::MatrixXd hessian(double lambda) const;

  /// ln det(WKᵀWK + λLᵀL + diag(p)) − ln det⁺(λLᵀL), det⁺ over the penalised
  /// subspace. By factors, which is quick, and accurate to 1e−4 up to stiffest().
  /// @param lambda     not above that.
  /// @param precision  p.
  [[nodiscard]] double log_volume(double lambda, const Eigen::VectorXd& precision) const;

  /// Largest λ with λLᵀL at most 1e12 times WKᵀWK, by their traces.
  [[nodiscard]] double stiffest() const { return 1e12 * normal_.trace() / roughness_.trace(); }

  /// λ in equal ratios, from almost only the null space of L to as many degrees of freedom as 0.85
  /// of the rows with those of the known scatter, or of the coefficients, and almost all that the
  /// data determine; both without the constraints.
  [[nodiscard]] std::vector<double> lambda_grid(std::size_t count) const;

  /// @param start  free coefficients of a neighbour's solution, or all.
  [[nodiscard]] SmoothingPoint solve(double lambda, std::vector<bool> start) const;

  /// The solution without the limits; edf and likelihood are then those of a linear smoother.
  [[nodiscard]] SmoothingPoint solve_unlimited(double lambda) const;

  /// ∂(fitted datum)/∂(datum) of each row at a solution of solve(); their sum is its edf.
  [[nodiscard]] Eigen::VectorXd leverage(const SmoothingPoint& point) const;

  /// The solutions for all λ of a grid, each started from the one before it.
  [[nodiscard]] std::vector<SmoothingPoint> path(const std::vector<double>& lambdas) const;

 private:
  /// Diagonals in the basis that makes both diagonal: WKᵀWK ~ data, LᵀL ~ penalty.
  struct Spectrum {
    Eigen::ArrayXd data;
    Eigen::ArrayXd penalty;
  };
  struct LazySpectrum {
    std::once_flag found;
    Spectrum value;
  };

  [[nodiscard]] Spectrum find_spectrum() const;
  /// Computed on first use: comparing models does not need it.
  [[nodiscard]] const Spectrum& spectrum() const;
  [[nodiscard]] double unconstrained_edf(double lambda) const;
  [[nodiscard]] double likelihood(const SmoothingPoint& point) const;
  void score(SmoothingPoint& point) const;
  [[nodiscard]] double free_edf(const QuadraticProgram::Solution& solution,
                                const Eigen::MatrixXd& hessian, double lambda) const;

  Eigen::MatrixXd design_;
  Eigen::VectorXd data_;
  Eigen::MatrixXd penalty_;
  Eigen::VectorXd area_;
  Eigen::Index unpenalised_;
  KnownScatter known_;
  Eigen::MatrixXd normal_;         // WKᵀWK
  Eigen::MatrixXd normal_ridged_;  // with a ridge at rounding level
  Eigen::MatrixXd roughness_;      // LᵀL
  Eigen::VectorXd linear_;         // WKᵀWd
  double log_penalty_;             // ln det LLᵀ
  std::shared_ptr<LazySpectrum> spectrum_ = std::make_shared<LazySpectrum>();  // of all copies
};

/// Counts of the inner solutions of an inversion: the result depends on them, but is not among
/// them.
struct InnerSolutions {
  std::size_t count = 0;
  std::size_t not_converged = 0;

  void add(const QuadraticProgram::Solution& solution) {
    ++count;
    if (!solution.optimal()) ++not_converged;
  }
};

/// What a point of a path may have to be chosen.
struct SmoothingBounds {
  double most_edf = 0.0;
  double most_residual = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool hold(const SmoothingPoint& point) const {
    return point.edf <= most_edf && point.residual <= most_residual;
  }
};

/// Index of the chosen point of a path. @param path  not empty.
[[nodiscard]] std::size_t choose(const std::vector<SmoothingPoint>& path, SmoothingRule rule,
                                 const SmoothingBounds& bounds);

}  // namespace microslip
