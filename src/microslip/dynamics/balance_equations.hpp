// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "microslip/dynamics/harmonic_force.hpp"
#include "microslip/dynamics/jointed_structure.hpp"
#include "microslip/dynamics/steady_vibration.hpp"
#include "microslip/dynamics/structure_side.hpp"
#include "microslip/dynamics/target.hpp"

namespace microslip {

/// The equations of harmonic balance, condensed onto the joints. Internal to dynamics.
///
/// Unknowns z: the coefficients of each joint's displacement, n = J(2H + 1) of them, then ω and A.
/// Equations: n of balance; two targets, or one and a place on a curve, complete them. All are
/// scaled: residuals of balance to the motion of their joint, the others to what they prescribe.
class BalanceEquations {
 public:
  BalanceEquations(const JointedStructure& structure, const ResponsePoint& response,
                   std::size_t harmonics, std::size_t samples);

  /// n.
  [[nodiscard]] Eigen::Index balance_count() const { return count_; }
  /// n + 2.
  [[nodiscard]] Eigen::Index unknown_count() const { return count_ + 2; }

  /// Goes to z: all below is there. Derivatives, which are half of the work, are computed when they are
  /// first asked for.
  void evaluate(const Eigen::VectorXd& z);

  /// What is to be zero, m, and its derivatives, n × (n + 2).
  [[nodiscard]] const Eigen::VectorXd& residual() const { return values_.residual; }
  [[nodiscard]] const Eigen::MatrixXd& jacobian();

  /// What a loss factor of the joints adds to the derivatives by their displacements while they are
  /// stuck, n × n: F = k(1 + iη)u.
  [[nodiscard]] Eigen::MatrixXd stuck_damping(double loss_factor);

  /// w_1, m, and its derivatives.
  [[nodiscard]] std::complex<double> response() const { return values_.response; }
  [[nodiscard]] const Eigen::RowVectorXcd& response_gradient();

  /// ln of the response in its kind, and its derivatives.
  [[nodiscard]] double log_response() const;
  [[nodiscard]] Eigen::RowVectorXd log_response_gradient();

  /// How far z misses a target, relative (a phase: in rad), and its derivatives.
  [[nodiscard]] double miss(const Target& target) const;
  [[nodiscard]] Eigen::RowVectorXd miss_gradient(const Target& target);

  /// A quantity at z.
  [[nodiscard]] double value(Quantity quantity) const;

  /// The size of the motion about the mean of the joint of each unknown, m, then ω and A: what makes
  /// z relative. A joint that hardly moves counts as moving 1e-6 of the one that moves most.
  [[nodiscard]] Eigen::VectorXd scale() const;

  /// The solution at z, with its energies.
  [[nodiscard]] SteadyVibration vibration();

  [[nodiscard]] const JointedStructure& structure() const { return structure_; }

 private:
  [[nodiscard]] StructureSide::Input input() const;
  void differentiate();
  void add_joint_cycles(SteadyVibration& vibration) const;
  void add_energies(SteadyVibration& vibration) const;

  const JointedStructure& structure_;
  ResponseKind kind_;
  std::size_t harmonics_;
  HarmonicForce joint_force_;
  std::unique_ptr<StructureSide> side_;
  Eigen::Index count_;

  Eigen::VectorXd z_;
  Eigen::VectorXd displacement_;
  Eigen::VectorXd tension_;
  Eigen::VectorXd force_;
  std::vector<Eigen::MatrixXd> tangents_;  // ∂F/∂u of each joint, transposed
  std::vector<HarmonicForce::Cycle> cycles_;
  StructureSide::Values values_;
  bool differentiated_ = false;
  StructureSide::Derivatives change_;
  Eigen::MatrixXd jacobian_;
  Eigen::RowVectorXcd gradient_;
};

/// Why a solution is none although its equations are solved to the tolerance: energy appears or is
/// lost in it. At a resonance that nothing damps rounding alone does that. Empty where
/// energy_imbalance ≤ 1e4 times the tolerance, at least 1e-8.
[[nodiscard]] std::string energy_doubt(const SteadyVibration& vibration, double tolerance);

}  // namespace microslip
