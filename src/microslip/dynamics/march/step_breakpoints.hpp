// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "microslip/dynamics/march/joint_path.hpp"
#include "microslip/dynamics/march/march_weights.hpp"
#include "microslip/dynamics/march/step_cubic.hpp"

namespace microslip {

/// What knots inside of a step add to the end of it. Internal to dynamics.
///
/// The weights of a step (march_weights.hpp) take a load that is one cubic over it. Where a joint
/// turns or its tangent jumps inside, its force is a piecewise cubic F, and e = F − H is what the
/// cubic H through its ends leaves out. A mode of impulse response g makes of it
///
///     q₁ = … + ∫ g(h − t) e dt,    q̇₁ = … + ∫ ġ(h − t) e dt
///
/// With g over the step as a series of Chebyshev polynomials these are sums over the moments
/// ∫ T_m(1 − 2t/h) e dt/h of e, which do not depend on the mode.
inline constexpr std::size_t kKnotTerms = 10;

using KnotMoments = std::array<double, kKnotTerms>;

/// The moments of e, N.
/// @param knots  by rising share. @param force  H. @param terms  how many of them, at most
///     kKnotTerms; the others are 0.
[[nodiscard]] KnotMoments knot_moments(std::span<const JointWay::Knot> knots,
                                       const StepCubic& force, std::size_t terms = kKnotTerms);

/// ∫ e over the step up to some shares, N.
/// @param shares  in (0, 1], rising. @param integrals  one a share.
void integrate_knots(std::span<const JointWay::Knot> knots, const StepCubic& force,
                     std::span<const double> shares, double* integrals);

/// The series of h g and of ġ, times h.
class KnotWeights {
 public:
  /// One number a mode, padded.
  /// @param stiffness  ω², s⁻². @param damping  ηω, s⁻¹.
  KnotWeights(std::span<const double> stiffness, std::span<const double> damping);

  /// The longest step for which kKnotTerms are enough, s: g is wrong by less than 1e-5 of its
  /// largest value in it.
  [[nodiscard]] double longest() const { return longest_; }
  /// Does nothing where that is its length already.
  void set_length(double length);
  [[nodiscard]] double length() const { return length_; }
  /// How many terms the series need at this length, where modes move less than in the longest step.
  [[nodiscard]] std::size_t terms() const { return terms_; }

  enum Kind { kOfDisplacement, kOfVelocity, kKinds };
  /// [group][term][kind][lane].
  [[nodiscard]] const double* data() const { return weights_.data(); }

 private:
  std::vector<double> stiffness_, damping_, weights_;
  double longest_ = std::numeric_limits<double>::infinity();
  double length_ = 0.0;
  std::size_t terms_ = kKnotTerms;
};

}  // namespace microslip
