// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/cycle/cycle_extremes.hpp"
#include "microslip/dynamics/cycle/cycle_motion.hpp"
#include "microslip/dynamics/cycle/kink_correction.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip {

/// The method of HarmonicForce: the samples of a cycle, the branches they lie on, and the sums over
/// them. Internal to dynamics.
///
/// With F′ the tangent and T the row of a sample, that of a branch adds to the Jacobian
/// Σ T F′ Tᵀ + Σ T (f_r′ − F′ T_r)ᵀ: the first sum over all branches is a matrix of multiplication
/// by F′(τ), and the second is of rank 1 on each branch.
///
/// Where no even harmonic moves, x(τ + π) = −x(τ), the second half of the cycle is the negated
/// first, and half of it is evaluated: its sums are half of those in odd harmonics of the force,
/// and in derivatives of odd harmonics by odd and even by even ones. Their other entries vanish
/// over the whole cycle.
class SteadyCycle {
 public:
  SteadyCycle(std::size_t harmonics, std::size_t samples);

  [[nodiscard]] Eigen::Index coefficients() const { return coefficient_count(basis_.harmonics()); }

  CycleMotion evaluate(const Joint& joint, std::span<const double> displacement,
                       std::span<double> force, std::span<double> jacobian);

  [[nodiscard]] std::size_t reaches() const { return reaches_.size(); }
  [[nodiscard]] double reach(std::size_t rank) const { return reaches_[rank].half; }
  void reach_gradient(std::size_t rank, std::span<double> gradient) const;

  [[nodiscard]] std::size_t turns() const { return extremes_.size(); }
  [[nodiscard]] CycleTurn turn(std::size_t i) const {
    return {extremes_[i].tau, extremes_[i].displacement};
  }
  void turn_gradient(std::size_t i, std::span<double> gradient) const;

 private:
  /// The force at an extreme and its derivatives by the coefficients are those of column `at`.
  struct Reversal {
    std::size_t at;
    double force;
  };

  /// Extent of a branch: half of the distance from its reversal, or, of the first extreme, |x| from
  /// virgin rest, m.
  struct Reach {
    double half;
    std::size_t at;
    std::size_t from;  ///< as `at`: on the virgin curve
  };

  /// Samples between two extremes, in which x is monotone.
  struct Stretch {
    std::size_t from;  ///< the extremes
    std::size_t to;
    double sign;         ///< +1 loading, −1 unloading
    Eigen::Index first;  ///< sample
    Eigen::Index samples;
  };

  /// Columns needed for a wave of one kind.
  struct Columns {
    Columns(Wave which, std::size_t harmonics);

    Wave wave;
    std::vector<Eigen::Index> motion;  ///< of the basis: the coefficients of x and of the force
    /// Columns of the sums over F′: all up to H, then the others that its moments have; of an odd
    /// wave F′ has even harmonics alone.
    std::vector<Eigen::Index> sums;
  };

  void begin(std::span<const double> displacement);
  void at_rest(const Joint& joint);
  void march(const Joint& joint);
  void turn_round(Eigen::Index first);
  void hand_over(std::span<double> force, std::span<double> jacobian);
  void segment(const Joint& joint, std::size_t from, std::size_t to, Eigen::Index samples);
  void branch(const Joint& joint, const Reversal& origin, double sign, Eigen::Index first,
              Eigen::Index samples);
  void block(const Joint& joint, const Reversal& origin, double sign, Eigen::Index first,
             Eigen::Index samples);
  [[nodiscard]] Eigen::Index samples_up_to(double end, const Stretch& stretch) const;
  void kinks_of_atoms(const Joint& joint, const Stretch& stretch, const Reversal& origin,
                      double from, double to);
  void kink_of_closing(const Joint& joint, const Stretch& stretch, double end);
  [[nodiscard]] double angle_at(const Stretch& stretch, double x) const;
  [[nodiscard]] double in_interval(double tau, Eigen::Index next) const;
  [[nodiscard]] Reversal reversal_on(const Joint& joint, const Reversal& origin, double sign,
                                     std::size_t at);

  TrigonometricBasis basis_;
  double step_;  // h, between two samples, rad
  Columns any_;
  Columns odd_;
  const Columns* columns_ = &any_;  // of the motion at hand
  bool half_ = false;               // an odd wave that moves
  CycleExtremes extremes_;
  std::vector<double> motion_;  // the coefficients of these columns
  Eigen::VectorXd x_;
  Eigen::VectorXd force_;
  Eigen::VectorXd slope_;        // F′/k
  Eigen::MatrixXd rows_;         // T at each extreme, a column an extreme
  Eigen::MatrixXd gradients_;    // of the force there
  std::vector<Reversal> stack_;  // as in Memory
  std::vector<Reach> reaches_;   // the farthest first
  KinkCorrection kinks_;
  Eigen::VectorXd jump_gradient_;      // of the jump of the tangent at a kink
  Eigen::VectorXd part_;               // sums of F′ over one block of samples
  Eigen::VectorXd moments_;            // of F′ over all samples
  Eigen::MatrixXd through_reversals_;  // the part of the Jacobian through the reversals
  std::vector<double> sums_;           // of the force
};

}  // namespace microslip
