// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/inversion/inversion_basis.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// The unknowns of one joint. Internal to calibrate.

namespace microslip {

/// The stiffness density of a joint over its slip displacement x* = f*/k and the elastic remainder
/// of the range,
///
///     ψ(x*) = (k₀/X) t s^χ₀ θ(s),   s = x*/X,   K_e = k₀ e,   k = K_e + ∫ψ dx*,
///
/// θ linear between the knots of InversionBasis, t such that θ = 1 is half of k₀. Coefficients are
/// θ, then e; all ≥ 0.
class JointUnknowns {
 public:
  /// @param stiffness     k₀, N/m: of the stuck joint, as given.
  /// @param length        X, m: where the density ends.
  /// @param lowest        smallest amplitude over X, in (0, 1).
  /// @param exponent      χ₀ of the basis, in (−1, 0].
  /// @param coefficients  how many θ without edges.
  /// @param edges         where ψ may jump, rising, m; one too close to the next or to an end is
  ///                      left out.
  JointUnknowns(double stiffness, double length, double lowest, double exponent, int coefficients,
                const std::vector<double>& edges = {});

  /// The unknowns with edges at these places of uniform().
  [[nodiscard]] JointUnknowns with_edges(const std::vector<BasisEdge>& edges) const;

  /// The unknowns with ψ = 0 on some of the ranges between edges, which then have no coefficients.
  /// @param empty  which of them; not all.
  [[nodiscard]] JointUnknowns without(const std::vector<bool>& empty) const;

  /// The same range with a coefficient for each knot of ψ in place of θ: it can represent
  /// densities of any exponent, and with any of these edges. It has no penalty().
  /// @param edges  rising, m.
  [[nodiscard]] JointUnknowns by_knots(const std::vector<double>& edges = {}) const;

  [[nodiscard]] Eigen::Index size() const { return nodal_.cols() + 1; }
  [[nodiscard]] double stiffness() const { return stiffness_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double exponent() const { return exponent_; }

  /// How many θ without edges.
  [[nodiscard]] int coefficients() const { return coefficients_; }

  /// Slip displacements at which ψ may jump, m.
  [[nodiscard]] std::vector<double> edges() const;
  /// The basis of θ without edges, of s.
  [[nodiscard]] InversionBasis uniform() const { return {lowest_, 1.0, exponent_, coefficients_}; }
  /// The edges as places among the knots of uniform().
  [[nodiscard]] std::vector<BasisEdge> basis_edges() const;
  /// The middle of each row of penalty() among these knots.
  [[nodiscard]] Eigen::VectorXd middles() const;
  /// The number of θ of each range between edges that has some.
  [[nodiscard]] std::vector<Eigen::Index> ranges() const;

  /// 0 and knots through which ψ is straight, m.
  [[nodiscard]] const std::vector<double>& slip_displacement() const { return slip_; }

  /// Rows that give ψ at slip_displacement(), D and the first-harmonic stiffness k_eq of an
  /// amplitude, and k over k₀ from coefficients.
  [[nodiscard]] const Eigen::MatrixXd& density_matrix() const { return density_; }
  [[nodiscard]] Eigen::RowVectorXd dissipation_row(double amplitude) const;  ///< J
  [[nodiscard]] Eigen::RowVectorXd secant_row(double amplitude) const;       ///< N/m
  [[nodiscard]] Eigen::RowVectorXd stiffness_row() const;                    ///< 1

  /// L with ‖Lθ‖² the roughness of θ: over all coefficients but the last.
  [[nodiscard]] Eigen::MatrixXd penalty() const;

  /// The joint of coefficients; a known stiffness is kept.
  /// @param known  whether k is k₀.
  [[nodiscard]] Joint joint(const Eigen::VectorXd& x, bool known) const;

  /// Coefficients of a spring that does not slip.
  [[nodiscard]] Eigen::VectorXd stuck() const;
  /// Coefficients that follow another density at the knots, or in proportion to it where that
  /// alone would be more than k.
  /// @param other  unknowns of the same joint. @param x  its coefficients.
  [[nodiscard]] Eigen::VectorXd projected(const JointUnknowns& other,
                                          const Eigen::VectorXd& x) const;

 private:
  JointUnknowns(double stiffness, double length, double lowest, double exponent, int coefficients,
                const std::vector<BasisEdge>& edges);
  [[nodiscard]] std::vector<Eigen::Index> kept() const;
  [[nodiscard]] std::vector<Eigen::Index> kept_rows() const;
  void begin_power_law();
  void refine(int parts);
  void read_density();

  double stiffness_;
  double length_;
  double lowest_;
  double exponent_;
  int coefficients_;
  InversionBasis basis_;
  std::vector<bool> empty_;  // which of its ranges
  double theta_scale_;
  std::vector<double> knots_;  // s
  Eigen::MatrixXd nodal_;      // p at them from θ
  std::vector<double> place_;  // s of each coefficient
  Eigen::VectorXd there_;      // p at its place from a coefficient
  std::vector<double> slip_;
  Eigen::MatrixXd density_;
  Eigen::RowVectorXd area_;  // ∫ψ dx* over k₀, and 0 of e
};

}  // namespace microslip
