// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>

#include "microslip/algebra/core.hpp"
#include "microslip/modes/symmetric_factor.hpp"

namespace microslip {

/// M ẍ + (K + B diag(k) Bᵀ) x = f, in the degrees of freedom that remain after supports and rigid
/// spiders. Each column of B is a motion with a spring: kept separate from K, as the motion of many
/// nodes would fill it.
struct VibratingSystem {
  Eigen::SparseMatrix<double> stiffness;       ///< K, both triangles; n × n
  Eigen::SparseMatrix<double> mass;            ///< M, both triangles; n × n; ≥ 0
  Eigen::SparseMatrix<double> spring_motions;  ///< B; n × s, s may be 0
  Eigen::VectorXd spring_stiffness;            ///< k, N/m; s values, > 0
  /// The largest error of an entry of K over the entry, beyond that of a double: of matrices that
  /// were written with few digits. From 0.
  double stiffness_rounding = 0.0;
  /// And what it may be, where the entries may as well be exact. From 0; less than
  /// stiffness_rounding has no meaning.
  double possible_rounding = 0.0;

  /// n.
  [[nodiscard]] Eigen::Index size() const { return stiffness.rows(); }
  /// (K + B diag(k) Bᵀ) x; x may have several columns.
  [[nodiscard]] Eigen::MatrixXd stiffness_times(const Eigen::MatrixXd& x) const;
  /// 16 ε + stiffness_rounding with ε of a double: an entry is a sum over the points of some
  /// elements.
  [[nodiscard]] double entry_error() const;
  /// The larger of that and 16 ε + possible_rounding.
  [[nodiscard]] double possible_entry_error() const;
  /// (|K| + |B| diag(k) |B|ᵀ)|x|.
  [[nodiscard]] Eigen::VectorXd sizes_times(const Eigen::VectorXd& x) const;
  /// A bound, per row, of what rounding of the entries changes in stiffness_times(x):
  /// entry_error() of sizes_times(x).
  [[nodiscard]] Eigen::VectorXd rounding_times(const Eigen::VectorXd& x) const;
};

/// The factors of K + B diag(k) Bᵀ − σM, by those of the matrix that has the forces in the springs
/// as unknowns of their own,
///
///     [ K − σM    B        ]
///     [ Bᵀ       −diag(1/k) ]
///
/// whose negative eigenvalues are those of K + B diag(k) Bᵀ − σM and s more.
class ShiftedFactor {
 public:
  /// @param system  must be there while this one is made only.
  /// @param shift   σ, rad²/s²; no eigenvalue of the system.
  /// @throws InputError  where that is singular, or the memory too small.
  ShiftedFactor(const VibratingSystem& system, double shift);

  /// x of (K + B diag(k) Bᵀ − σM) x = b; b may have several columns.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides) const;

  /// The number of eigenvalues ω² below σ (Sturm count), where M has no negative one.
  [[nodiscard]] std::size_t eigenvalues_below() const;

 private:
  Eigen::Index size_;
  Eigen::Index springs_;
  SymmetricFactor factor_;
};

}  // namespace microslip
