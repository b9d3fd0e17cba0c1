// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/cycle/harmonic_force.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/harmonic/structure_operator.hpp"
#include "microslip/dynamics/harmonic/target.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Where a heavy atom starts to slip on a branch of a joint's motion: the equations bend there. See
/// heavy_atoms(). Internal to dynamics.
struct Onset {
  std::size_t joint;
  std::size_t rank;     ///< rank of the branch among the joint's, from the longest
  double displacement;  ///< extent of the branch on which the atom is about to slip, m
};

/// Where two maxima, or two minima, of a joint's motion are equal: the one that was an inner loop
/// is the outer one behind that, and the equations bend there. The extremes are those next to the
/// angles. Internal to dynamics.
struct Tie {
  std::size_t joint;
  double first;   ///< τ in the period, rad
  double second;  ///< τ in the period, rad
  double size;    ///< size of the motion, m, to which a miss is relative
};

/// The equations of harmonic balance, condensed onto the joints. Internal to dynamics.
///
/// Unknowns z: the coefficients of each joint's displacement, n = J(2H + 1) of them, then ω and A;
/// with modal forcing, ω and ξ.
/// Equations: n of balance; two targets, or one and a place on a curve, complete them. All are
/// scaled: residuals of balance to the motion of their joint, the others to what they prescribe.
class BalanceEquations {
 public:
  BalanceEquations(const JointedStructure& structure, const ResponsePoint& response,
                   std::size_t harmonics, std::size_t samples,
                   Forcing forcing = Forcing::kExcitation);

  /// n.
  [[nodiscard]] Eigen::Index balance_count() const { return count_; }
  /// n + 2.
  [[nodiscard]] Eigen::Index unknown_count() const { return count_ + 2; }

  /// Evaluates the equations at z. Derivatives, which are half of the work, are computed when they
  /// are first requested.
  void evaluate(const Eigen::VectorXd& z);

  /// The unknowns that move, rising, ω and A among them. With odd harmonics only in force and
  /// motion, even ones are exactly 0 and remain so; otherwise all.
  [[nodiscard]] const std::vector<Eigen::Index>& moving() const { return odd_wave_ ? odd_ : all_; }

  /// The residuals, m, n of them.
  [[nodiscard]] const Eigen::VectorXd& residual() const { return values_.residual; }
  /// The derivatives of those by the unknowns that move; no row of the others. Where all move, n ×
  /// (n + 2).
  [[nodiscard]] const Eigen::MatrixXd& jacobian();

  /// The derivatives of all n by the displacements of the joints, n × n, with a loss factor of the
  /// joints as long as they are stuck, F = k(1 + iη)u.
  [[nodiscard]] Eigen::MatrixXd damped_jacobian(double loss_factor);

  /// w_1, m, and its derivatives.
  [[nodiscard]] std::complex<double> response() const { return values_.response; }
  [[nodiscard]] const Eigen::RowVectorXcd& response_gradient();

  /// ln of the response in its kind, and its derivatives.
  [[nodiscard]] double log_response() const;
  [[nodiscard]] Eigen::RowVectorXd log_response_gradient();

  /// How far z misses a target, relative (a phase: in rad), and its derivatives.
  [[nodiscard]] double miss(const Target& target) const;
  [[nodiscard]] Eigen::RowVectorXd miss_gradient(const Target& target);

  /// Slip forces of the heavy atoms of a joint, N, rising; see heavy_atoms().
  [[nodiscard]] const std::vector<double>& atoms(std::size_t joint) const { return atoms_[joint]; }
  /// How far the branches of a joint with heavy atoms go, m, the farthest first; see
  /// HarmonicForce::reaches(). Empty without such atoms.
  [[nodiscard]] std::span<const double> reaches(std::size_t joint) const {
    return branches_[joint].reaches;
  }
  /// Relative distance of z from an onset, and its derivatives; −1 and 0 where there is no such
  /// branch.
  [[nodiscard]] double miss(const Onset& onset) const;
  [[nodiscard]] Eigen::RowVectorXd miss_gradient(const Onset& onset) const;
  /// All ties that there may be: a pair of maxima or minima each. None without inner loops.
  [[nodiscard]] std::vector<Tie> ties() const;
  /// How far z misses a tie, relative, and its derivatives; 1 and 0 where the two became one.
  [[nodiscard]] double miss(const Tie& tie) const;
  [[nodiscard]] Eigen::RowVectorXd miss_gradient(const Tie& tie) const;
  /// For each joint in turn: the number of branches of its motion, and the number of them on which
  /// each heavy atom slips, by rising slip force.
  [[nodiscard]] std::vector<std::size_t> slipping() const;
  /// Whether a heavy atom starts or ceases to slip from one such state to the other. Inner loops
  /// that appear or vanish change a joint's numbers too, but not the derivatives: such joints do
  /// not count.
  [[nodiscard]] bool slips_otherwise(const std::vector<std::size_t>& one,
                                     const std::vector<std::size_t>& other) const;

  /// A quantity at z.
  [[nodiscard]] double value(Quantity quantity) const;

  /// The size of the motion about the mean of the joint of each unknown, m, then ω and A: to which
  /// z is relative. A joint that hardly moves counts as moving 1e-6 of the one that moves most, or
  /// of the response point, and 1e-3 of its static displacement.
  [[nodiscard]] Eigen::VectorXd scale() const;

  /// z of a vibration that is n times as large, as far as it is linear; the mean motion by static
  /// loads is unchanged.
  [[nodiscard]] Eigen::VectorXd enlarged(Eigen::VectorXd z, double n) const;

  /// The mean motion of z becomes that of the static loads alone, where there are any.
  void set_at_rest(Eigen::VectorXd& z) const;

  /// z of a vibration of the structure in these harmonics.
  [[nodiscard]] Eigen::VectorXd unknowns(const SteadyVibration& vibration) const;

  /// ∂lag/∂z of the phase lag of the response, rad over the unit of z.
  [[nodiscard]] Eigen::RowVectorXd lag_gradient();

  /// The solution at z, with its energies.
  [[nodiscard]] SteadyVibration vibration();

  [[nodiscard]] const JointedStructure& structure() const { return structure_; }
  [[nodiscard]] Forcing forcing() const { return forcing_; }

 private:
  [[nodiscard]] StructureOperator::Input input() const;
  [[nodiscard]] bool is_odd_wave() const;
  void differentiate();
  void keep_branches(std::size_t joint);
  void keep_turns(std::size_t joint);
  [[nodiscard]] std::size_t turn_at(std::size_t joint, double angle) const;
  void add_linear_damping(std::size_t joint);
  void add_joint_cycles(SteadyVibration& vibration) const;
  double add_input(SteadyVibration& vibration) const;
  void add_energies(SteadyVibration& vibration) const;

  const JointedStructure& structure_;
  ResponseKind kind_;
  std::size_t harmonics_;
  Forcing forcing_;
  HarmonicForce joint_force_;
  std::unique_ptr<StructureOperator> operator_;
  Eigen::Index count_;
  std::vector<double> resting_;  // u of each joint under static loads; empty without
  bool odd_forces_;              // no even harmonic acts, nor arises from odd ones
  std::vector<Eigen::Index> all_;
  std::vector<Eigen::Index> odd_;  // without even harmonics

  Eigen::VectorXd z_;
  Eigen::VectorXd displacement_;
  Eigen::VectorXd tension_;
  Eigen::VectorXd force_;
  std::vector<Eigen::MatrixXd> tangents_;  // ∂F/∂u of each joint, transposed
  std::vector<HarmonicForce::Cycle> cycles_;
  struct Branches {
    std::vector<double> reaches;
    Eigen::MatrixXd gradients;  // one column per branch
  };
  std::vector<std::vector<double>> atoms_;  // heavy ones of each joint, N
  std::vector<Branches> branches_;          // of each joint; none without such atoms
  struct Turns {
    std::vector<HarmonicForce::Turn> at;
    Eigen::MatrixXd gradients;  // of the displacements, one column per turn
  };
  std::vector<Turns> turns_;  // of each joint; none without inner loops
  StructureOperator::Values values_;
  bool odd_wave_ = false;
  bool differentiated_ = false;
  bool assembled_ = false;  // the Jacobian
  StructureOperator::Derivatives change_;
  Eigen::MatrixXd jacobian_;
  Eigen::RowVectorXcd gradient_;
};

/// Reason why a solution is rejected although its equations are solved to the tolerance: its energy
/// does not balance. At an undamped resonance rounding alone does that. Empty where
/// energy_imbalance ≤ 1e4 times the tolerance, at least 1e-8.
[[nodiscard]] std::string energy_doubt(const SteadyVibration& vibration, double tolerance);

}  // namespace microslip
