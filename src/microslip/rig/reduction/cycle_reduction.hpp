// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/rig/setup/modal_observer.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"

/// @file
/// Reduction of the Fourier series of the signals of one cycle, the mean cycle fitted to a whole
/// record or a single one. Internal to rig.

namespace microslip {

/// Source of the joint displacement among the signals.
struct SignalLayout {
  std::size_t accelerometers = 0;
  std::optional<std::size_t> at_exciter = {};              ///< the accelerometer there
  std::optional<RigVibrometer::Measures> vibrometer = {};  ///< none: from the kinematics
};

/// The layout of a rig's records. @param use_vibrometer  false: as without one.
[[nodiscard]] SignalLayout signal_layout(const Rig& rig, bool use_vibrometer);

struct CycleResult {
  ModalMotion motion;
  FourierSeries displacement;          ///< u, m
  FourierSeries exciter_acceleration;  ///< ẅ(S), m/s²
  double amplitude = 0.0;              ///< A, m
  double input_energy = 0.0;           ///< W_ext, J
  double linear_dissipation = 0.0;     ///< W_lin, J
  double secant_stiffness = 0.0;       ///< k_eq, N/m

  [[nodiscard]] double dissipation() const { return input_energy - linear_dissipation; }
};

/// Damping ratio of the structure with its joint: W_ext/(4πT) with the kinetic energy
/// T = ½ ω² Σ|q_i1|² that it has in phase resonance at this amplitude.
/// @param resonance_frequency  ω/(2π), Hz; above 0.
[[nodiscard]] double damping_ratio_of(const CycleResult& cycle, double resonance_frequency);

class CycleReduction {
 public:
  /// @param state  outlives this. @param omega, harmonics  of the series to be reduced.
  CycleReduction(const StickState& state, SignalLayout layout, double omega, std::size_t harmonics);

  /// @param series  force, accelerometers, vibrometer where the layout has it.
  [[nodiscard]] CycleResult reduce(std::span<const FourierSeries> series) const;

 private:
  [[nodiscard]] FourierSeries exciter_acceleration(std::span<const FourierSeries> series,
                                                   const ModalMotion& motion) const;
  [[nodiscard]] FourierSeries displacement(std::span<const FourierSeries> series,
                                           const ModalMotion& motion) const;

  const StickState& state_;
  SignalLayout layout_;
  ModalObserver observer_;
};

}  // namespace microslip
