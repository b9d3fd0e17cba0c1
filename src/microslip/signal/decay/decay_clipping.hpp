// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "microslip/signal/decay/decay_window.hpp"

/// @file
/// Whether a decay is clipped, beneath noise that hides the level on which it stays.
/// Internal to signal.

namespace microslip {

/// What the range of the signal lacks in the first windows of a decay, one after the other, up to
/// the first in which it does not: an instrument is at its limit where the amplitude is largest.
/// @param signal     evenly sampled.
/// @param rate       sampling rate, Hz.
/// @param windows    of the decay.
/// @param noise_std  of a sample.
/// @return  shares of the range of the fundamental, one per clipped window; may be empty.
[[nodiscard]] std::vector<double> clipped_windows(std::span<const double> signal, double rate,
                                                  std::span<const DecayWindow> windows,
                                                  double noise_std);

}  // namespace microslip
