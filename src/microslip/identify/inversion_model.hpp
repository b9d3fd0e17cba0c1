// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "microslip/identify/inversion.hpp"
#include "microslip/identify/inversion_basis.hpp"
#include "microslip/identify/levels.hpp"
#include "microslip/identify/smoothing_path.hpp"

/// @file
/// One pass of the inversion, in scaled variables. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// Of k, what k_eq is known to at best where nobody says it: a smooth column of k_eq is no proof of
/// an exact one, and would outweigh all of D.
inline constexpr double kLeastSofteningScatter = 1e-3;

/// The levels in the variables of InversionBasis.
struct ScaledLevels {
  /// @param merged     sorted, without equal amplitudes.
  /// @param stiffness  k, N/m.
  ScaledLevels(const MergedLevels& merged, double stiffness);

  double stiffness;             ///< k, N/m
  double largest_amplitude;     ///< A_max, m
  double largest_slip_force;    ///< kA_max, N
  Eigen::VectorXd amplitude;    ///< a
  Eigen::VectorXd dissipation;  ///< d
  Eigen::VectorXd floor;        ///< a d below this does not get a larger weight
  Eigen::VectorXd repeats;      ///< levels merged into one
  Eigen::VectorXd spread;       ///< Σ(d_i − d)² of these
  Eigen::VectorXd softening;    ///< 1 − k_eq/k; empty where not measured
  Eigen::VectorXd softening_std;
  bool softening_std_given = false;
  Eigen::VectorXd dissipation_std;  ///< empty where not given
  double informative_levels = 0.0;  ///< where given: without those whose deviation was raised
  Eigen::VectorXd amplitude_std;    ///< empty where not given
  double relative_std;  ///< of d where no deviation is given: its unit, or an estimate beside k_eq

  [[nodiscard]] bool deviations_given() const { return dissipation_std.size() > 0; }
};

/// What a pass is to assume.
struct PassOptions {
  double exponent = 0.0;  ///< χ₀
  double top = 1.0;       ///< end of the density, s
  bool linear_damping = false;
  bool atom = false;  ///< at the top
  int coefficients = 0;
  Eigen::VectorXd fit;              ///< d of an earlier pass, for the weights
  Eigen::VectorXd penalty_weights;  ///< ω, one a second difference; empty for 1
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

  /// Weighted square of what repeated levels differ by, and the degrees of freedom that it tells of
  /// their scatter: beside the residual, which sees their means alone.
  [[nodiscard]] double repeat_residual() const { return repeat_residual_; }
  [[nodiscard]] double repeat_freedom() const { return repeat_freedom_; }

  /// d of the levels from coefficients.
  [[nodiscard]] Eigen::VectorXd dissipation(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd softening(const Eigen::VectorXd& x) const;

  /// Rows of D; those of k_eq follow them.
  [[nodiscard]] Eigen::Index dissipation_rows() const { return dissipation_.rows(); }

  /// W of the rows of D.
  [[nodiscard]] const Eigen::VectorXd& dissipation_weights() const { return dissipation_weights_; }

  /// The part of the coefficients that is θ, at the scale of 1.
  [[nodiscard]] Eigen::VectorXd theta(const Eigen::VectorXd& x) const {
    return x.head(basis_.size());
  }

  /// The matrix that makes φ at the knots of the basis, 1/N, from coefficients.
  [[nodiscard]] Eigen::MatrixXd density_matrix() const;

  /// φ at the knots of the basis, 1/N.
  [[nodiscard]] Eigen::VectorXd density(const Eigen::VectorXd& x) const;

  /// β/k, 1; 0 without that column.
  [[nodiscard]] double linear_damping(const Eigen::VectorXd& x) const;

  /// Weight of the atom, 1; 0 without that column.
  [[nodiscard]] double atom_weight(const Eigen::VectorXd& x) const;

  // Set by the pass that chose λ; what bands() starts from.
  std::vector<SmoothingPoint> path;
  std::size_t chosen = 0;
  double most_edf = 0.0;
  bool lambda_fixed = false;
  double scatter = 0.0;              ///< σ̂, in units of 1/W
  double dissipation_scatter = 1.0;  ///< of the rows of D, over σ̂
  double softening_scatter = 1.0;    ///< of those of k_eq, over σ̂
  /// What samples perturb the rows of k_eq by at least, over σ̂: an error common to neighbouring
  /// levels does not show in their scatter.
  double least_softening_scatter = 0.0;
  double degrees_of_freedom = 0.0;  ///< ν of σ̂²

  [[nodiscard]] const SmoothingPoint& solution() const { return path[chosen]; }

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
  Eigen::VectorXd dissipation_weights_;
  double informative_rows_;
  double repeat_residual_;
  double repeat_freedom_;
  SmoothingProblem problem_;
};

}  // namespace microslip
