// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/inversion/inversion_basis.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// One pass of the inversion, in scaled variables. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// The levels in the variables of InversionBasis.
struct ScaledLevels {
  /// @param levels  must outlive this.
  /// @param k       stiffness of the stuck joint, N/m.
  ScaledLevels(const LevelEvidence& levels, double k);

  const LevelEvidence& evidence;
  double stiffness;             ///< k, N/m
  double largest_slip_force;    ///< kA_max, N
  double energy;                ///< kA_max², J
  Eigen::VectorXd amplitude;    ///< a
  Eigen::VectorXd dissipation;  ///< d
  Eigen::VectorXd floor;        ///< a d below this counts as zero
  Eigen::VectorXd typical;      ///< d smoothed without a model
  Eigen::VectorXd softening;    ///< 1 − k_eq/k; empty where not measured

  /// Unit of the scatter found. Two kinds of rows share one solution: where their scatter is not
  /// known it is estimated before, as its ratio decides their relative weight.
  LevelScatter unit;
};

/// Assumptions of a pass.
struct PassOptions {
  double exponent = 0.0;  ///< χ₀
  double top = 1.0;       ///< end of the density, s
  bool linear_damping = false;
  bool atom = false;  ///< at the top
  int coefficients = 0;
  Eigen::VectorXd fit;  ///< d of an earlier pass, for the weights
  /// ω, one per second difference without edges; empty for 1.
  Eigen::VectorXd penalty_weights;
  double trend = 0.0;  ///< ln λ at the last knot minus that at the first
  std::vector<BasisEdge> edges;
};

/// A linear model of the levels with its coefficients, and how to read them.
class InversionModel {
 public:
  InversionModel(const ScaledLevels& levels, const PassOptions& options);

  [[nodiscard]] const SmoothingProblem& problem() const { return problem_; }
  [[nodiscard]] const InversionBasis& basis() const { return basis_; }
  [[nodiscard]] double largest_slip_force() const { return largest_slip_force_; }
  [[nodiscard]] double stiffness() const { return stiffness_; }

  /// Rows that carry information: levels at the floor of the weights do not.
  [[nodiscard]] double informative_rows() const { return informative_rows_; }

  /// What is known of the scatter of D in addition to the residual: the differences between
  /// repeated levels, whose means alone are in it, and prior knowledge where the levels are few,
  ///
  ///     ν₀ = ν (20 − n)/8, from 0 to ν,   ν = 10 where σ was given, and 4 with σ = 1 % of D
  ///
  /// otherwise, as if by ν₀ further levels that scatter as expected; n levels with their repeats,
  /// two for each amplitude at most. Only ν₀ counts in the choice of λ: repeats may differ by what
  /// all levels of a session share.
  [[nodiscard]] const KnownScatter& known_scatter() const { return known_; }

  /// (20 − n)/8 within 0 and 1: how much prior knowledge counts, and whether it does.
  [[nodiscard]] double few_share() const { return few_share_; }
  [[nodiscard]] bool few_levels() const { return few_share_ > 0.0; }

  /// Whether σ of D was given: then weights are its reciprocals, and the scatter is near 1.
  [[nodiscard]] bool deviations_given() const { return deviations_given_; }

  /// The same of k_eq: prior knowledge alone.
  [[nodiscard]] const KnownScatter& known_softening_scatter() const { return known_softening_; }

  /// d of the levels from coefficients.
  [[nodiscard]] Eigen::VectorXd dissipation(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd softening(const Eigen::VectorXd& x) const;

  /// Rows of D; those of k_eq follow them.
  [[nodiscard]] Eigen::Index dissipation_rows() const { return dissipation_.rows(); }

  /// W of the rows.
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }

  /// Rows that give β/k and the weight of the atom from coefficients: the value of a coefficient
  /// of 1 in its column, and 0 in all others.
  [[nodiscard]] Eigen::VectorXd linear_damping_row() const;
  [[nodiscard]] Eigen::VectorXd atom_row() const;

  /// The part of the coefficients that is θ, at the scale of 1.
  [[nodiscard]] Eigen::VectorXd theta(const Eigen::VectorXd& x) const {
    return x.head(basis_.size());
  }

  /// The matrix that gives φ at the knots of the basis, 1/N, from coefficients.
  [[nodiscard]] Eigen::MatrixXd density_matrix() const;

  /// φ at the knots of the basis, 1/N.
  [[nodiscard]] Eigen::VectorXd density(const Eigen::VectorXd& x) const;

  /// β/k, 1; 0 without that column.
  [[nodiscard]] double linear_damping(const Eigen::VectorXd& x) const {
    return linear_damping_row().dot(x);
  }

  /// Weight of the atom, 1; 0 without that column.
  [[nodiscard]] double atom_weight(const Eigen::VectorXd& x) const { return atom_row().dot(x); }

  // Set by the pass that chose λ.
  std::vector<SmoothingPoint> path;
  std::size_t chosen = 0;
  double most_edf = 0.0;
  bool lambda_fixed = false;
  bool shape_sought = false;         ///< edges and trend
  double trend = 0.0;                ///< of PassOptions
  double scatter = 0.0;              ///< σ̂, in units of 1/W
  double dissipation_scatter = 1.0;  ///< of the rows of D, over σ̂
  double softening_scatter = 1.0;    ///< of those of k_eq, over σ̂
  /// The least perturbation of the rows of k_eq by samples, over σ̂: an error common to
  /// neighbouring levels does not show in their scatter.
  double least_softening_scatter = 0.0;
  double degrees_of_freedom = 0.0;  ///< ν of σ̂²

  /// Takes path, scatter and all other results of the choice of λ from another model of the same
  /// levels.
  void take_smoothing(const InversionModel& other);

  [[nodiscard]] const SmoothingPoint& solution() const { return path[chosen]; }

  /// −2 log of the likelihood of λ and the edges, with all coefficients and the scatter
  /// integrated out: to compare models with different edges, up to a common constant. The
  /// unpenalised part, a straight line on each of the ranges between edges, is given the size of
  /// the solution as its prior deviation. Infinite where the levels leave too little freedom.
  [[nodiscard]] double evidence(const SmoothingPoint& point) const;

 private:
  struct Columns;
  InversionModel(const ScaledLevels& levels, const PassOptions& options, InversionBasis basis);
  InversionModel(const ScaledLevels& levels, const InversionBasis& basis, Columns columns);

  InversionBasis basis_;
  double stiffness_;
  double largest_slip_force_;
  double theta_scale_;
  double damping_scale_;
  double atom_scale_;
  Eigen::Index damping_column_;
  Eigen::Index atom_column_;
  Eigen::MatrixXd dissipation_;  // levels × coefficients, unweighted
  Eigen::MatrixXd softening_;
  Eigen::VectorXd weights_;
  double informative_rows_;
  KnownScatter known_;
  double few_share_;
  bool deviations_given_;
  KnownScatter known_softening_;
  double unresolved_;  // of the scatter, below which nothing is proved
  SmoothingProblem problem_;
};

}  // namespace microslip
