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

/// The effect of breakpoints inside of a step on its end. Internal to dynamics.
///
/// The weights of a step (march_weights.hpp) take a load that is one cubic over it. Where a joint
/// turns or its tangent jumps inside, its force is a piecewise cubic F, and e = F − H is its
/// difference from the cubic H through its ends. A mode of impulse response g responds by
///
///     q₁ = … + ∫ g(h − t) e dt,    q̇₁ = … + ∫ ġ(h − t) e dt
///
/// With g over the step as a series of Chebyshev polynomials these are sums over the moments
/// ∫ T_m(1 − 2t/h) e dt/h of e, which do not depend on the mode.
inline constexpr std::size_t kBreakpointTerms = 10;

using BreakpointMoments = std::array<double, kBreakpointTerms>;

/// The moments of e, N.
/// @param breakpoints  by rising share. @param force  H. @param terms  how many of them, at most
///     kBreakpointTerms; the others are 0.
[[nodiscard]] BreakpointMoments breakpoint_moments(
    std::span<const JointPath::Breakpoint> breakpoints, const StepCubic& force,
    std::size_t terms = kBreakpointTerms);

/// ∫ e over the step up to some shares, N.
/// @param shares  in (0, 1], rising. @param integrals  one per share.
void integrate_breakpoints(std::span<const JointPath::Breakpoint> breakpoints,
                           const StepCubic& force, std::span<const double> shares,
                           double* integrals);

/// The series of h g and of ġ, times h.
class BreakpointWeights {
 public:
  /// One number per mode, padded.
  /// @param stiffness  ω², s⁻². @param damping  ηω, s⁻¹.
  BreakpointWeights(std::span<const double> stiffness, std::span<const double> damping);

  /// The longest step for which kBreakpointTerms are enough, s: g is wrong by less than 1e-5 of its
  /// largest value in it.
  [[nodiscard]] double longest() const { return longest_; }
  /// Without effect if that is its length already.
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
  std::size_t terms_ = kBreakpointTerms;
};

}  // namespace microslip
