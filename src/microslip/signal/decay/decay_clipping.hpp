// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "microslip/signal/decay/decay_window.hpp"

/// @file
/// Whether a decay is clipped, beneath noise that hides the level on which it stays.
/// Internal to signal.

namespace microslip {

/// What the range of a signal lacks of that of its fundamental, in the middle half of a window and
/// at the same samples, over the latter: the fundamental of a sine that is clipped at c is larger
/// than c, 1.27 c at most. Many samples a period, noise and other modes make the range larger,
/// which is negative here; a third harmonic of 3 % in a force that slips flattens by as much. 1,
/// below 0.22.
/// @param signal  evenly sampled.
/// @param rate    sampling rate, Hz.
[[nodiscard]] double lacking_range(std::span<const double> signal, double rate,
                                   const DecayWindow& window);

}  // namespace microslip
