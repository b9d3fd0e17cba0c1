// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/dynamics/march/march_weights.hpp"

namespace microslip {

/// Gauss–Lobatto with 5 points on [0, 1]: the inner ones; the ends weigh kEndWeight each. Exact for
/// polynomials of degree 7 [DLMF 3.5(v)]. Internal to dynamics.
inline constexpr std::size_t kInnerPoints = 3;
inline constexpr std::array<double, kInnerPoints> kInnerPoint{0.17267316464601143, 0.5,
                                                              0.8273268353539886};
inline constexpr std::array<double, kInnerPoints> kInnerWeight{49.0 / 180.0, 16.0 / 45.0,
                                                               49.0 / 180.0};
inline constexpr double kEndWeight = 1.0 / 20.0;

/// The velocity of each mode at these points of a step of length h, for the load of StepWeights
/// over it: with its values at the ends and in the middle
///
///     q̇ = e₂₁q₀ + e₂₂q̇₀ + c₀p₀ + d₀ṗ₀ + c₁p₁ + d₁ṗ₁ + c_m p_m
///
/// so that ∫ f q̇ dt and ∫ q̇² dt are those of the motion, whatever the step over the period. The
/// contribution of breakpoints inside of the step (step_breakpoints.hpp) up to the time t, ∫ ġ(t −
/// τ) e dτ, is taken as ġ(½t) ∫ e dτ.
class StepQuadrature {
 public:
  /// The order in which weights of a point stand, kLanes each.
  enum Kind { kE21, kE22, kC0, kD0, kC1, kD1, kCM, kOfBreakpoints, kKinds };

  explicit StepQuadrature(std::span<const Mode> modes);

  /// Without effect if that is its length already. @param length  h, s; > 0.
  void set_length(double length);

  /// [group][point][kind][lane].
  [[nodiscard]] const double* data() const { return weights_.data(); }

 private:
  std::vector<Mode> modes_;
  StepWeights part_;  // of a step, up to a point
  std::vector<double> weights_;
  std::size_t groups_;
  double length_ = 0.0;
};

}  // namespace microslip
