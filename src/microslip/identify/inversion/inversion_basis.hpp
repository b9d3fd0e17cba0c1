// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/core.hpp"

/// @file
/// The unknowns of the inversion, and D and k_eq as linear functions of them. Internal: Eigen stays
/// out of the installed headers.
///
/// All in scaled variables: amplitude a = A/A_max, slip force s = f*/(kA_max), density p = kA_max
/// φ, dissipation d = D/(kA_max²), softening 1 − k_eq/k.

namespace microslip {

/// Place where a density may jump and bend: one of the equally spaced knots is moved there, twice.
struct BasisEdge {
  int knot = 0;     ///< number of that knot among them, from 0
  double at = 0.0;  ///< where it is, in spacings of them: within ½ of `knot`
};

/// The density is linear between knots, constant below the first, and continuous but at edges,
/// whose two knots are kWidth apart, relative; so the result is written without loss as a
/// piecewise-linear part. The roughness penalty acts on the coefficients θ: p at knot j is
/// reference_j θ_j. With the reference s^χ₀ (χ₀ from the log–log slope of D) a power law
/// is a constant θ and costs nothing. The first coefficient includes the knots below the lowest
/// amplitude: D determines only two moments of the density there.
class InversionBasis {
 public:
  /// @param lowest        lowest scaled amplitude, in (0, 1).
  /// @param top           where the density ends, in (lowest, 1].
  /// @param exponent      χ₀, in (−1, 0].
  /// @param coefficients  how many θ without edges, one per equally spaced knot; ≥ 4.
  /// @param edges         rising, kLeastBetween knots or more from each other and from both ends.
  InversionBasis(double lowest, double top, double exponent, int coefficients,
                 const std::vector<BasisEdge>& edges = {});

  /// The same with knots at other places, which are equally far apart to the roughness penalty:
  /// where they are close to each other the density may change more quickly.
  /// @param lowest, top, exponent  as above.
  /// @param places  of the knots among equally spaced ones, in their spacings: rising from 0 to
  ///                places.size() − 1; 4 or more.
  InversionBasis(double lowest, double top, double exponent, const std::vector<double>& places);

  static constexpr double kWidth = 1e-6;   ///< of an edge, over its slip force
  static constexpr int kLeastBetween = 2;  ///< spacings

  [[nodiscard]] Eigen::Index size() const { return coordinate_.size(); }

  /// Ranges between edges: on each a straight line of θ costs nothing.
  [[nodiscard]] Eigen::Index ranges() const { return static_cast<Eigen::Index>(first_.size()); }

  /// Slip forces of the edges, s.
  [[nodiscard]] std::vector<double> edges() const;

  /// The number of θ of a range. @param range  from 0.
  [[nodiscard]] Eigen::Index size_of(Eigen::Index range) const;

  /// The slip force s at a place among the equally spaced knots. @param at  in their spacings.
  [[nodiscard]] double slip_force(double at) const;

  /// The inverse: where a slip force s is among them, in their spacings.
  [[nodiscard]] double place(double s) const;

  /// Knots s, rising.
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }

  /// p at the knots from θ: a matrix of knots × coefficients.
  [[nodiscard]] const Eigen::MatrixXd& nodal() const { return nodal_; }

  /// d of each amplitude from θ, (7): amplitudes × coefficients.
  [[nodiscard]] Eigen::MatrixXd dissipation(const Eigen::VectorXd& amplitude) const;

  /// 1 − k_eq/k of each amplitude from θ: amplitudes × coefficients.
  [[nodiscard]] Eigen::MatrixXd softening(const Eigen::VectorXd& amplitude) const;

  /// Area ∫p ds from p at the knots: one per knot.
  [[nodiscard]] Eigen::VectorXd knot_area() const;

  /// The place of each knot among the equally spaced ones, 0 to 1; 0 for the ones below them.
  [[nodiscard]] Eigen::VectorXd knot_places() const;

  /// Area ∫p ds from θ.
  [[nodiscard]] Eigen::VectorXd area() const;

  /// Second differences of θ over the coordinate in which the knots are equally spaced, with its
  /// range as the unit, none across an edge: rows (size − 2 ranges) × size.
  [[nodiscard]] Eigen::MatrixXd second_differences() const;

  /// The place of the middle coefficient of each row of second_differences(), in spacings.
  [[nodiscard]] Eigen::VectorXd middles() const;

 private:
  void set_range(double first, double top);
  void set_ends(double first, double top, double exponent);

  double intervals_;
  double power_;
  double from_;  // of s^power
  double to_;
  Eigen::VectorXd coordinate_;       // of each θ, in spacings
  std::vector<Eigen::Index> first_;  // θ of each range
  std::vector<double> knots_;
  Eigen::MatrixXd nodal_;
};

}  // namespace microslip
