// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/structure/modal_model.hpp"

namespace microslip {

/// Modes come in groups of this many, each a lane of the loops over modes; the last is padded with
/// modes of no weight. Internal to dynamics.
inline constexpr std::size_t kLanes = 8;

/// The least number of lanes for so many modes.
[[nodiscard]] inline std::size_t padded(std::size_t modes) {
  return (modes + kLanes - 1) / kLanes * kLanes;
}

/// g(1) and g′(1) of g″ + 2δg′ + θ²g = 0 with g(0) = 0 and g′(0) = 1.
struct ImpulseResponse {
  double value;
  double slope;
};
[[nodiscard]] ImpulseResponse impulse_response(double delta, double theta_squared);

/// The effect of a step of length h on the state (q, q̇) of a mode under the load p, p over the
/// step the cubic with the values and slopes at its ends (Hermite) and its excess over that in the
/// middle, p_m·16τ²(1 − τ)²: with τ = t/h
///
///     q₁ = e₁₁q₀ + e₁₂q̇₀ + a₀p₀ + b₀ṗ₀ + a₁p₁ + b₁ṗ₁ + a_m p_m
///     q̇₁ = e₂₁q₀ + e₂₂q̇₀ + c₀p₀ + d₀ṗ₀ + c₁p₁ + d₁ṗ₁ + c_m p_m
///
/// The Duhamel integrals ∫₀ʰ g(h − t) τᵐ dt of the impulse response g, in closed form: exact for
/// any ω_i, η_i and h.
class StepWeights {
 public:
  /// The order in which weights of a group stand, kLanes each.
  enum Kind { kE11, kE12, kE21, kE22, kA0, kB0, kA1, kB1, kC0, kD0, kC1, kD1, kAM, kCM, kKinds };

  explicit StepWeights(std::span<const Mode> modes);

  /// @param length  h, s; > 0.
  void set_length(double length);
  [[nodiscard]] double length() const { return length_; }

  /// [group][kind][lane].
  [[nodiscard]] const double* data() const { return weights_.data(); }

  /// One weight of one mode.
  [[nodiscard]] double operator()(Kind kind, std::size_t mode) const {
    return weights_[(mode / kLanes * kKinds + kind) * kLanes + mode % kLanes];
  }

 private:
  std::vector<double> frequency_, loss_factor_;  // padded
  std::vector<double> weights_;
  double length_ = 0.0;
};

}  // namespace microslip
