// SPDX-License-Identifier: MIT
#pragma once

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
/// clamped at 0; at L supported against transverse motion and, by a torsional spring, against
/// rotation: the beam of the friction rig of [AR14 (10)], with k_θ = k r² for a stuck contact of
/// stiffness k at the radius r.
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

}  // namespace microslip
