// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/rig/setup/rig.hpp"

namespace microslip {

/// The linear structure of a test with the joint stuck, in mass-normalised modes q_i:
///
///     q̈_i + (damping of loss factor η_i) + ω_i² q_i
///         = f φ_i(S) + ψ_i g − Σ_r Γ_ir q_r N,        g = N + k Σ_r ψ_r q_r         [AR14 (12)]
///     u = Σ_i ψ_i q_i − ½ Σ_ir Γ_ir q_i q_r + c N,    N = −F_joint(u)               [AR14 (13)]
///
/// with ψ_i = r φ_i′(L) and Γ_ir = ∫ φ_i′φ_r′ dx for a beam. g is what the joint does beyond the
/// spring k that the modes already contain: 0 while it sticks, but for the compliance c in series.
struct StickState {
  std::vector<double> omega;                       ///< ω_i, rad/s
  std::vector<double> loss_factor;                 ///< η_i, 1
  std::vector<double> excitation;                  ///< φ_i(S), kg^-1/2
  std::vector<double> joint;                       ///< ψ_i, kg^-1/2
  std::vector<std::vector<double>> accelerometer;  ///< φ_i at each, kg^-1/2
  /// Γ, row by row, 1/(m kg); empty where the structure has no such term: with modes.
  std::vector<double> shortening;
  double stiffness = 0.0;         ///< k, N/m; 0 where it is not known, which only k_eq needs
  double axial_compliance = 0.0;  ///< c = L/(ĀE), m/N

  /// The number of modes.
  [[nodiscard]] std::size_t modes() const { return omega.size(); }
};

/// Modes of a beam that are enough for its static deflection under a moment at L to have converged
/// to 1 %: as needed for the joint displacement without vibrometer.
inline constexpr std::size_t kBeamModes = 30;

/// The stick state of a rig. Where the rig states the stick frequency, k follows from it: the
/// torsional spring that gives the beam this first frequency is k r²/(1 + k c).
/// @param rig    a test.
/// @param modes  how many of a beam; 0: as many as the test states, or kBeamModes. Of a rig with
///               modes all are taken.
/// @throws InputError  as check_rig(), and where no stiffness gives the stick frequency.
[[nodiscard]] StickState stick_state(const Rig& rig, std::size_t modes = 0);

/// First natural frequency, Hz, of the structure when the joint does −δ·(Σψ_r q_r) less than stuck,
/// g = δ Σψ_r q_r: the least eigenvalue of diag(ω_i²) − δ ψψᵀ. 0 where that is below 0.
/// @param state      of a rig.
/// @param softening  δ, N/m.
[[nodiscard]] double natural_frequency(const StickState& state, double softening);

}  // namespace microslip
