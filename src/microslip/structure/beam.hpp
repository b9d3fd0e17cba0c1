// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/structure/uniform_beam.hpp"

namespace microslip {

/// How many natural frequencies of the beam lie below ω: exact whatever their distance, by the
/// count of [Wittrick & Williams].
/// @param beam               as check_beam() demands.
/// @param angular_frequency  ω, rad/s; ≥ 0, with (ω² ρA L⁴/EI)^¼ ≤ 10000 (about 3000 modes).
/// @throws InputError  for a beam or ω out of its range.
[[nodiscard]] std::size_t natural_frequencies_below(const Beam& beam, double angular_frequency);

/// The torsional spring k_θ, N m/rad, with which the first natural frequency of the beam is f₁;
/// k_θ = k r² then measures the stiffness k of the contact. Not a search: the spring is minus the
/// dynamic stiffness of the beam's end against rotation at ω = 2πf₁, which one march along the
/// beam gives. beam.tip_stiffness is not used.
/// @param beam             as check_beam() demands.
/// @param first_frequency  f₁, Hz; at least that of the pinned beam (k_θ = 0), below that of the
///                         clamped one (k_θ = ∞).
/// @throws InputError  for a beam out of its range; for an f₁ out of its own, naming that.
[[nodiscard]] double spring_for_first_frequency(const Beam& beam, double first_frequency);

}  // namespace microslip
