// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/density.hpp"
#include "microslip/joint/virgin_curve.hpp"

namespace microslip {

/// A frictional contact as a parallel-series Iwan model: infinitely many Jenkins elements (a spring
/// in series with a Coulomb slider) in parallel. Immutable, so one Joint serves any number of
/// threads and simulations; the state of a simulation is in its Memory.
///
///     x    relative displacement across the joint, m
///     k    stiffness of the fully stuck joint, N/m
///     φ    distribution density of the slip forces, 1/N
///     F    virgin force, N (see VirginCurve)
class Joint {
 public:
  /// @param stiffness  k, N/m; positive and finite.
  /// @param density    φ; a four-parameter part must have K_T = stiffness.
  /// @throws InputError  where a rule is broken.
  Joint(double stiffness, SlipDensity density);

  /// Segalman's four-parameter joint.
  /// @param macroslip_force  F_S, N; > 0.
  /// @param stiffness        K_T, N/m; > 0.
  /// @param chi              χ, 1; −1 < χ ≤ 0.
  /// @param beta             β, 1; ≥ 0.
  static Joint four_parameter(double macroslip_force, double stiffness, double chi, double beta);

  /// k, N/m.
  [[nodiscard]] double stiffness() const { return stiffness_; }
  /// φ.
  [[nodiscard]] const SlipDensity& density() const { return density_; }
  /// F over the elastic force kx.
  [[nodiscard]] const VirginCurve& virgin_curve() const { return virgin_curve_; }

  /// F(x), N, odd in x: the force on first loading. [AR14 (2)] At x = ±∞ the limit, which is ±f_y
  /// or, with an elastic remainder, infinite; NaN where x is NaN.
  [[nodiscard]] double virgin_force(double x) const;

  /// F′(x) = k[1 − Φ0(k|x|)], N/m. At an atom the value beyond it. [AR14 (4)] At
  /// x = ±∞ the elastic remainder of k; NaN where x is NaN.
  [[nodiscard]] double tangent_stiffness(double x) const;

  /// f_y = Φ1(∞), N: the largest force that the sliders carry. [AR14 (1)] With an elastic remainder
  /// the force of the joint itself has no limit.
  [[nodiscard]] double macroslip_force() const { return density_.total().first; }

  /// The displacement at which every slider has slipped, m; infinite with an elastic remainder.
  [[nodiscard]] double macroslip_displacement() const;

 private:
  double stiffness_;
  SlipDensity density_;
  VirginCurve virgin_curve_;
};

}  // namespace microslip
