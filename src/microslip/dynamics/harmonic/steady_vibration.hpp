// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/structure/modal_model.hpp"

namespace microslip {

/// The cycle of one joint. Harmonics are factors of e^{inωt}, entry n that of harmonic n; entry 0
/// is the mean.
struct JointCycle {
  std::string name;                                ///< of the joint
  std::vector<std::complex<double>> displacement;  ///< u_n, m
  std::vector<std::complex<double>> force;  ///< F_n, N: the restoring force, βi u_n/π included
  double amplitude = 0.0;                   ///< half of max u − min u, m
  /// D = ∮ F du of the harmonics, J per cycle: all that the joint loses, as levels have it.
  double dissipation = 0.0;
  double linear_dissipation = 0.0;  ///< Σ_n nβ|u_n|², J per cycle: the part of D that is not slip
  std::size_t reversals = 0;        ///< in a cycle; 2 without inner loops
};

/// A steady periodic vibration.
struct SteadyVibration {
  double angular_frequency = 0.0;  ///< ω, rad/s
  double force_amplitude = 0.0;    ///< A, N; the phase of the force is 0
  double response = 0.0;           ///< at the response point, in its kind
  double phase_lag = 0.0;          ///< of the displacement there, rad; in (−π, π]
  std::vector<std::vector<std::complex<double>>> modal;  ///< q_{i,n}: [mode][harmonic], kg^½ m
  std::vector<JointCycle> joints;                        ///< in the order of the structure

  double input_energy = 0.0;        ///< W_ext = ∮ Σ f ẇ dt, J per cycle [AR14 (17)]
  double linear_dissipation = 0.0;  ///< W_lin = Σ_i Σ_n nπ Im Z_i(nω) |q_{i,n}|², J per cycle
  /// |W_ext − W_lin − ΣD|/W_ext, 1: 0 in an exact solution of the equations, so that it measures
  /// the convergence of this one. [AR14 (15) (16)] With next to no losses W_ext is the small
  /// difference of the energy fed in and returned: then over 1e-3 of the apparent work Σ
  /// nπ|f_n||w_n|.
  double energy_imbalance = 0.0;

  /// ω/(2π), Hz.
  [[nodiscard]] double frequency() const;

  /// ζ by the ratio of the energy lost per cycle to the largest kinetic energy of the first
  /// harmonic:
  ///
  ///     ζ = (W_lin + ΣD)/(2π ω² Σ_i |q_{i,1}|²)
  ///
  /// with q mass-normalised, so that Σ_i |q_{i,1}|² is the square of the modal amplitude. In phase
  /// resonance of a linear structure with one mode it is that mode's damping ratio. 0 where nothing
  /// moves.
  [[nodiscard]] double damping_ratio() const;

  /// The displacement at a point, harmonics 0 to H, m.
  /// @throws InputError  where the model has no such point, or other modes than the vibration.
  [[nodiscard]] std::vector<std::complex<double>> displacement(const ModalModel& model,
                                                               std::string_view point) const;
  /// The motion conjugate to a load at a place, harmonics 0 to H: the displacement of a point, m;
  /// −Σ Γ_i q_i of a base, kg m, so that a force on the one and an acceleration of the other feed ∮
  /// f ẇ dt.
  /// @throws InputError  as displacement().
  [[nodiscard]] std::vector<std::complex<double>> worked_on(const ModalModel& model,
                                                            std::string_view place) const;
  /// The displacement at a point including the motion of driven bases, harmonics 0 to H, m: that of
  /// displacement() and Σ_b r_p(b) x_b, −n²ω²x_b = A s_n. Without driven bases that of
  /// displacement().
  /// @throws InputError  as displacement().
  [[nodiscard]] std::vector<std::complex<double>> absolute_displacement(
      const JointedStructure& structure, std::string_view point) const;
  /// The acceleration of displacement(), −n²ω² times it, m/s².
  [[nodiscard]] std::vector<std::complex<double>> acceleration(const ModalModel& model,
                                                               std::string_view point) const;
};

/// Result of HarmonicBalance::solve().
struct VibrationResult {
  SteadyVibration vibration;  ///< the best that was found
  Summary summary;            ///< residual: of the equations, see HarmonicBalanceOptions
};

/// A curve of steady vibrations in its own order.
struct ResponseCurve {
  std::vector<SteadyVibration> points;  ///< in the order of the curve, the peaks among them
  /// Local maxima of the response over the force along the curve, located by its slope to 1e-7 of
  /// a step: of the response at constant force, minima of the force at
  /// constant response. At a corner of the curve, where an atom starts to slip, the corner itself.
  std::vector<SteadyVibration> peaks;
  std::vector<std::size_t> peak_points;  ///< i of each of them among the points
  /// i where the curve turns back in the quantity that it follows between points i − 1 and i + 1.
  std::vector<std::size_t> turning_points;
  std::vector<Warning> warnings;  ///< warnings that concern the points; tables repeat them
  Summary summary;                ///< of the whole curve: why it ended, and where
};

}  // namespace microslip
