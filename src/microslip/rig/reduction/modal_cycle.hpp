// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/rig/setup/joints_observer.hpp"
#include "microslip/rig/setup/structure_test.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"

/// @file
/// Reduction of the Fourier series of the signals of one cycle for several joints. Internal to rig.

namespace microslip {

struct JointCycleValues {
  double amplitude = 0.0;         ///< m
  double dissipation = 0.0;       ///< J
  double secant_stiffness = 0.0;  ///< N/m
};

struct ModalCycle {
  JointsMotion motion;
  double displacement = 0.0;        ///< first harmonic at the response point, m
  double input_energy = 0.0;        ///< W_ext, J
  double linear_dissipation = 0.0;  ///< W_lin, J
  std::optional<double> resonance;  ///< Hz
  std::vector<JointCycleValues> joints;

  [[nodiscard]] double dissipation() const { return input_energy - linear_dissipation; }
  /// Σ D_j − (W_ext − W_lin).
  [[nodiscard]] double energy_difference() const;
};

class ModalCycleReduction {
 public:
  /// @param test    outlives this.
  /// @param omega, harmonics  of the series to be reduced.
  ModalCycleReduction(const StructureTest& test, double omega, std::size_t harmonics,
                      const JointsObserverScales& scales);

  /// @param series  force, accelerometers.
  [[nodiscard]] ModalCycle reduce(std::span<const FourierSeries> series) const;
  /// With an unseen direction, see JointsObserver::observe_with().
  [[nodiscard]] ModalCycle reduce_with(std::span<const FourierSeries> series, std::size_t direction,
                                       double phase) const;

  [[nodiscard]] const JointsObserver& observer() const { return observer_; }

 private:
  [[nodiscard]] ModalCycle cycle_of(std::span<const FourierSeries> series,
                                    JointsMotion motion) const;
  /// Displacement of a point, as measured by the accelerometer there or as observed, m.
  [[nodiscard]] std::complex<double> displacement_at(std::span<const FourierSeries> series,
                                                     const JointsMotion& motion,
                                                     const std::string& point,
                                                     std::size_t harmonic) const;
  [[nodiscard]] double input_energy(std::span<const FourierSeries> series,
                                    const JointsMotion& motion) const;
  [[nodiscard]] double linear_dissipation(const JointsMotion& motion) const;

  const StructureTest& test_;
  JointsObserver observer_;
};

/// The frequency, Hz, near ω at which the displacement of the response point lags the force by π/2
/// (modulo π), with a fixed h_j = δ_j w_j of each joint j. None where there is no such frequency
/// within a tenth of ω.
[[nodiscard]] std::optional<double> phase_resonance(const StructureTest& test,
                                                    std::span<const std::complex<double>> delta,
                                                    double omega);

}  // namespace microslip
