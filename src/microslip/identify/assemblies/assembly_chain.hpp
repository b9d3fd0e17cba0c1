// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/assemblies/assembly_model.hpp"
#include "microslip/identify/posterior/posterior_chain.hpp"

/// @file
/// Draws of a density and of the deviations of assemblies from it. Internal: Eigen stays out of the
/// installed headers.

namespace microslip {

/// Standard deviations between assemblies.
struct AssemblySpread {
  double stiffness = 0.1;   ///< of ln k
  double slip_force = 0.1;  ///< of ln S
  double shape = 0.1;       ///< of each term of a shape, which is that of Φγ at any place
};

/// One draw.
struct AssemblyDraw {
  Eigen::VectorXd middle;         ///< p of the middle at the knots
  AssemblyDeviations deviations;  ///< of the assemblies
  AssemblySpread spread;
  double dissipation_scatter = 0.0;  ///< τ of the rows of D
};

/// Start of a chain.
struct AssemblyStart {
  ChainTarget target;  ///< penalty, its λ and limits on single coefficients; rows are set here
  ChainStart chain;    ///< x and λ
  AssemblyDeviations deviations;
};

/// A Markov chain of
///
///     p(x, λ, l, τ) · Π_f N(deviations_f; 0, σ_f²) · p(σ_f) · likelihood of all levels,
///
/// deviations being those from the middle of the assemblies that were measured: they add up to 0,
/// and the deviation of the middle of all assemblies from that one is N(0, σ²/J), which the
/// prediction adds. So the density in the middle and the deviations from it hardly depend on each
/// other, and are drawn in turn: x, λ, l and τ by PosteriorChain; deviations by steps that keep
/// their distribution for rows that are linear in them, corrected by Metropolis; each σ given the
/// deviations, and together with them as they are over σ.
class AssemblyChain {
 public:
  /// @param model  with its weights; must outlive this.
  AssemblyChain(const AssemblyModel& model, AssemblyStart start);
  AssemblyChain(const AssemblyChain&) = delete;
  AssemblyChain& operator=(const AssemblyChain&) = delete;

  /// Steps until the start is forgotten, during which rows are linearised anew.
  void settle(RandomStream& random);

  /// The next draw, correlated with the one before it.
  const AssemblyDraw& next(RandomStream& random);

 private:
  /// All rows, those of D, of k_eq and of its mean, the last without their common offset.
  struct Residual {
    Eigen::VectorXd dissipation;
    Eigen::VectorXd secant;
    Eigen::VectorXd stiffness;
  };

  void set_rows();
  void read_middle();
  [[nodiscard]] Residual residual(const Eigen::MatrixXd& contrast) const;
  [[nodiscard]] double square(const Residual& left) const;
  [[nodiscard]] double square_at(const Eigen::MatrixXd& contrast) const;
  [[nodiscard]] AssemblyDeviations deviations_of(const Eigen::MatrixXd& contrast) const;
  [[nodiscard]] Eigen::VectorXd precision() const;
  void linearise();
  void approximate();
  void go_to_best();
  void move_deviations(double kept, RandomStream& random);
  void draw_spread(RandomStream& random);
  void move_with_spread(double& spread, Eigen::Index column, Eigen::Index columns,
                        RandomStream& random);
  [[nodiscard]] Eigen::VectorXd without_common(const Eigen::VectorXd& rows) const;

  const AssemblyModel& model_;
  ChainTarget target_;
  Eigen::MatrixXd helmert_;   // deviations from contrasts: assemblies × (assemblies − 1)
  Eigen::MatrixXd contrast_;  // independent N(0, σ²): (assemblies − 1) × columns
  AssemblyDraw draw_;
  std::vector<double> scale_;       // τ of D, k_eq and its mean
  Eigen::VectorXd common_;          // unit vector of an offset common to all means of k_eq
  double square_ = 0.0;             // of the residual of the last draw
  Eigen::MatrixXd linear_at_;       // contrasts where rows were made linear
  Eigen::MatrixXd jacobian_[3];     // of the three kinds of rows over contrasts, column by column
  Eigen::VectorXd approximate_at_;  // mean of the deviations as if rows were linear
  Eigen::LLT<Eigen::MatrixXd> approximate_;  // and their precision
  PosteriorChain chain_;
};

}  // namespace microslip
