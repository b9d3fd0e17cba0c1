// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"

/// @file
/// Levels linearised about the current joints, and their weights. Internal to calibrate.

namespace microslip {

/// Kinds of rows: losses, frequencies, displacements of joints by sensors, offsets of modes, k.
/// Those of a kind share a scatter, which is found, but those of modes and k, which are known.
enum class RowKind { kLoss, kFrequency, kAmplitude, kMode, kStiffness };
inline constexpr std::array kRowKinds = {RowKind::kLoss, RowKind::kFrequency, RowKind::kAmplitude,
                                         RowKind::kMode, RowKind::kStiffness};
/// The kinds that are measured.
inline constexpr std::array kMeasuredKinds = {RowKind::kLoss, RowKind::kFrequency,
                                              RowKind::kAmplitude};

/// λ goes no further. Above, θ bends by less than a hundredth of the stiffness: no joint is known
/// to follow a power law so closely. Below, it is as free as the basis.
inline constexpr double kLeastLambda = 1e-8;
inline constexpr double kMostLambda = 1e3;

/// Relative tolerance of a given k of a joint: as good as exact, and well-conditioned.
inline constexpr double kKnownStiffness = 1e-5;

/// A prior of the coefficients from `begin` on: roughness ‖Lx‖² of unknown weight λ.
struct RoughnessBlock {
  Eigen::Index begin = 0;
  Eigen::Index free_count = 0;  ///< coefficients that it acts on: columns of L
  Eigen::MatrixXd rows;         ///< L, over those alone
  /// The number of coefficients of each range on which a straight line is not penalised.
  std::vector<Eigen::Index> ranges = {};
};

/// One kind of rows, each over its standard deviation where that is known and else over a guess.
struct WeightedRows {
  Eigen::MatrixXd design;
  Eigen::VectorXd data;
  double freedom_taken = 0.0;  ///< degrees of freedom used by offsets

  [[nodiscard]] double count() const { return static_cast<double>(data.size()) - freedom_taken; }
  /// Whether any degrees of freedom are left beside the offsets.
  [[nodiscard]] bool has_freedom() const { return count() > 0.5; }
};

/// ½ Σ ‖(A_k x − b_k)/τ_k‖² + ½ Σ λ_j ‖L_j x‖², x ≥ 0.
struct LinearEvidence {
  std::array<WeightedRows, kRowKinds.size()> rows;
  std::vector<RoughnessBlock> roughness;

  [[nodiscard]] const WeightedRows& of(RowKind kind) const {
    return rows[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] WeightedRows& of(RowKind kind) { return rows[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] Eigen::Index size() const { return rows[0].design.cols(); }
};

/// λ of each joint and τ of each kind of rows.
struct EvidenceWeights {
  std::vector<double> lambda;
  std::array<double, kRowKinds.size()> scatter{1.0, 1.0, 1.0, 1.0, 1.0};

  [[nodiscard]] double& of(RowKind kind) { return scatter[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] double of(RowKind kind) const { return scatter[static_cast<std::size_t>(kind)]; }
};

/// Bounds of τ of each kind of rows.
struct ScatterBounds {
  std::array<double, kRowKinds.size()> least{};
  std::array<double, kRowKinds.size()> most{
      std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::infinity()};
};

/// The matrix with a ridge at rounding level, so that it has a factor.
[[nodiscard]] Eigen::MatrixXd with_ridge(Eigen::MatrixXd hessian);

/// AᵀA, Aᵀb and LᵀL, from which every weighing is a sum.
class NormalEquations {
 public:
  explicit NormalEquations(const LinearEvidence& evidence);

  [[nodiscard]] const LinearEvidence& evidence() const { return evidence_; }
  [[nodiscard]] const Eigen::MatrixXd& information(RowKind kind) const {
    return information_[static_cast<std::size_t>(kind)];
  }
  /// LᵀL of a block, over its own coefficients.
  [[nodiscard]] const Eigen::MatrixXd& roughness(std::size_t block) const {
    return roughness_[block];
  }

  [[nodiscard]] Eigen::MatrixXd hessian(const EvidenceWeights& weights) const;
  [[nodiscard]] Eigen::VectorXd linear(const EvidenceWeights& weights) const;
  /// The prior: without the levels, with k as given and the modes as far off as levels tell.
  [[nodiscard]] Eigen::MatrixXd prior_hessian(const EvidenceWeights& weights) const;
  [[nodiscard]] Eigen::VectorXd prior_linear() const;

  /// ‖A_k x − b_k‖².
  [[nodiscard]] double residual(RowKind kind, const Eigen::VectorXd& x) const;
  /// ‖L_j x‖².
  [[nodiscard]] double roughness(std::size_t block, const Eigen::VectorXd& x) const;

 private:
  void add_roughness(const EvidenceWeights& weights, Eigen::MatrixXd& hessian) const;
  [[nodiscard]] double prior_weight() const;

  const LinearEvidence& evidence_;
  std::array<Eigen::MatrixXd, kRowKinds.size()> information_;
  std::array<Eigen::VectorXd, kRowKinds.size()> linear_;
  std::vector<Eigen::MatrixXd> roughness_;
};

/// The most likely coefficients with the weights estimated from the evidence.
struct SettledEvidence {
  Eigen::VectorXd x;
  EvidenceWeights weights;
  double edf = 0.0;                     ///< effective degrees of freedom of the levels
  std::vector<double> edf_by_joint;     ///< of each joint
  double likelihood = 0.0;              ///< −2 log restricted likelihood, up to a constant
  QuadraticProgram::Solution solution;  ///< of x, with its optimality conditions
};

/// λ and τ by restricted likelihood on the coefficients that are not 0 [Wood & Fasiolo,
/// Biometrics 73 (2017) 1071: λ_j ← λ_j (r_j/λ_j − tr H⁻¹S_j)/‖L_jx‖²; τ² ←
/// residual over the degrees of freedom that the solution leaves].
/// @param start   weights to begin with: near those of the solution.
/// @param bounds  of τ.
[[nodiscard]] SettledEvidence settle(const NormalEquations& equations, EvidenceWeights start,
                                     const ScatterBounds& bounds);

/// The most likely coefficients with given weights.
[[nodiscard]] SettledEvidence settle_with(const NormalEquations& equations,
                                          const EvidenceWeights& weights);

/// As settle() where the weights are unknown: the most likely of the results from several λ, as
/// the likelihood has a second maximum where all is scatter.
[[nodiscard]] SettledEvidence settle_from_afar(const NormalEquations& equations,
                                               const ScatterBounds& bounds);

}  // namespace microslip
