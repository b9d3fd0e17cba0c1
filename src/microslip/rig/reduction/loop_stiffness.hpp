// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/signal/harmonic/fourier_series.hpp"

/// @file
/// Internal to rig.

namespace microslip {

/// k_eq of the loop that force and displacement draw, as if the displacement had been harmonic: the
/// joint is rate-independent, so the loop does not change when it is passed through at another
/// pace,
///
///     k_eq = (1/πA) ∮ f cos θ dθ,     u = middle + A cos θ,     |dθ| = |u̇| dt/(A |sin θ|),
///
/// and its harmonics, 2 % in the reference rig at its highest level, do not matter. At a turning
/// point |u̇|/(A |sin θ|) tends to √(|ü|/A).
/// @param force         of the joint, N. @param displacement  u, m; of the same ω.
[[nodiscard]] double loop_stiffness(const FourierSeries& force, const FourierSeries& displacement);

}  // namespace microslip
