// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/base/error.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// A recording at even times t₀ + i/rate, i = 0 … ⌊(t_n − t₀)·rate⌋: each channel by the polynomial
/// of degree five through the six points nearest to each time (Lagrange; fewer where there are
/// fewer). Of a sine of p points a period at even times it is off by less than
/// (225/46080)·(2π/p)⁶ of its amplitude: 1e-4 at p = 12, 5e-6 at 20. No filter is applied, which
/// sets the lowest rate.
/// @param recording  real channels over time, evenly spaced or not; see check_recording().
/// @param rate       1/s; at least the mean rate of the recording, to 1 %, at most 100 times it.
/// @throws InputError  otherwise, and where an interval is above 3 mean ones: naming the source,
///                     the place and its times.
[[nodiscard]] Recording resampled(const Recording& recording, double rate);

/// The error where only evenly spaced times will do: it names the shortest and the longest
/// interval, and the rate to resample the recording at.
[[nodiscard]] InputError uneven_times(const Recording& recording);

}  // namespace microslip
