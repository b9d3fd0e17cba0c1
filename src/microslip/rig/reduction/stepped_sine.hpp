// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/stepped_sine_sweep.hpp"

namespace microslip {

/// The level of a sweep, by its resonance_of() (sweep_resonance.hpp). There
///
///     W_ext = π |F_1| |A_1|/ω²,
///
/// and W_lin, A and k_eq follow as in Reducer, by the rig's modes. Flags: warnings_of() of the
/// resonance.
/// @throws InputError  as resonance_of(); where the phase does not pass a quarter turn; where
///                     the rig has more than one accelerometer, or it is not at the exciter.
[[nodiscard]] ReducedLevel reduce_stepped_sine(const Reducer& reducer, const SteppedSine& sweep);

}  // namespace microslip
