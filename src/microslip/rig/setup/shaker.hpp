// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <span>

#include "microslip/rig/setup/rig.hpp"

/// @file
/// An electrodynamic shaker that drives a structure through a stinger, by its harmonics of e^{iΩt}.
/// With V the voltage at the coil, I its current, x the displacement of the armature, w that of the
/// structure at the drive point and F the force in the stinger, which the force transducer
/// measures,
///
///     V = (R + iΩL) I + iΩ Bl x                          coil
///     (k − Ω²m + iΩc) x = Bl I − F                       armature
///     F = k_s (x − w)                                    stinger
///
/// [Lang, Sound and Vibration 31 (1997), 4; McConnell & Varoto, Vibration Testing, 2nd ed. 2008,
/// ch. 6]. Without I and x, with D = k − Ω²m + iΩc + iΩ(Bl)²/(R + iΩL),
///
///     F = a V − b w,     a = Bl/[(R + iΩL)(1 + D/k_s)],     b = D/(1 + D/k_s).
///
/// b is what the structure feels of the shaker: its motion makes a force of its own. That is why
/// the force of a sinusoidal voltage is distorted where the motion is, and most at a resonance,
/// where the fundamental of the force is small.

namespace microslip {

/// a and b at one frequency.
struct ShakerTransfer {
  std::complex<double> voltage;       ///< a, N/V
  std::complex<double> displacement;  ///< b, N/m
};

/// a and b of a shaker.
/// @param shaker             as check_rig() demands.
/// @param angular_frequency  Ω, rad/s; ≥ 0, not checked.
[[nodiscard]] ShakerTransfer shaker_transfer(const RigShaker& shaker, double angular_frequency);

/// The energies of a cycle, J.
struct ShakerEnergy {
  double electrical = 0.0;  ///< ∮ V I dt
  double coil = 0.0;        ///< ∮ R I² dt
  double suspension = 0.0;  ///< ∮ c ẋ² dt
  double mechanical = 0.0;  ///< ∮ F ẇ dt, to the structure
};

/// Each from its own formula: electrical − coil − suspension − mechanical is 0 for quantities that
/// satisfy the equations above.
/// @param shaker             as check_rig() demands.
/// @param angular_frequency  ω of the cycle, rad/s; harmonic n is at nω.
/// @param voltage, force, displacement  V_n, F_n and w_n: entry n is harmonic n, entry 0 plays no
///                  part; as many of each.
[[nodiscard]] ShakerEnergy shaker_energy(const RigShaker& shaker, double angular_frequency,
                                         std::span<const std::complex<double>> voltage,
                                         std::span<const std::complex<double>> force,
                                         std::span<const std::complex<double>> displacement);

}  // namespace microslip
