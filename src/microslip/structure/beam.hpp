// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// A mass without rotary inertia on a beam: a sensor.
struct PointMass {
  double position;  ///< x, m; in [0, L]; at 0 and at L it does not move and has no effect
  double mass;      ///< kg; ≥ 0, and at most 10⁵⁰ times ρAL
};

/// A uniform, slender beam in bending (Euler–Bernoulli), with point masses m_j at x_j:
///
///     EI w⁗ + [ρA + Σ_j m_j δ(x − x_j)] ẅ = 0,   w(0) = w′(0) = 0,   w(L) = 0,
///     EI w″(L) = −k_θ w′(L)
///
/// clamped at 0; at L held against transverse motion and, by a torsional spring, against rotation:
/// the beam of the friction rig of [AR14 (10)], with k_θ = k r² for a stuck contact of stiffness k
/// at the radius r.
struct Beam {
  double length;                       ///< L, m; > 0
  double bending_stiffness;            ///< EI, N m²; > 0
  double mass_per_length;              ///< ρA, kg/m; > 0
  double tip_stiffness = 0.0;          ///< k_θ, N m/rad; from 0 (pinned) to infinity (clamped)
  std::vector<PointMass> masses = {};  ///< any number and order, two may be at one place
};

/// Checks the ranges above.
/// @throws InputError  naming the member and the rule it breaks.
void check_beam(const Beam& beam);

/// How many natural frequencies of the beam lie below ω: exact whatever their distance, by the
/// count of [Wittrick & Williams].
/// @param beam               as check_beam() demands.
/// @param angular_frequency  ω, rad/s; ≥ 0, with (ω² ρA L⁴/EI)^¼ ≤ 10000 (about 3000 modes).
/// @throws InputError  for a beam or ω out of its range.
[[nodiscard]] std::size_t natural_frequencies_below(const Beam& beam, double angular_frequency);

/// The torsional spring k_θ, N m/rad, with which the first natural frequency of the beam is f₁;
/// k_θ = k r² then measures the stiffness k of the contact. Not a search: the spring is minus the
/// dynamic stiffness of the beam's end against rotation at ω = 2πf₁, which one march along the beam
/// gives. What beam.tip_stiffness is does not matter.
/// @param beam             as check_beam() demands.
/// @param first_frequency  f₁, Hz; at least that of the pinned beam (k_θ = 0), below that of the
///                         clamped one (k_θ = ∞).
/// @throws InputError  for a beam out of its range; for an f₁ out of its own, naming that.
[[nodiscard]] double spring_for_first_frequency(const Beam& beam, double first_frequency);

}  // namespace microslip
