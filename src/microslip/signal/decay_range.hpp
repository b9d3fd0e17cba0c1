// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

/// @file
/// Which part of a record is free decay. Internal to signal.

namespace microslip {

/// The time, s from the first sample, from which a mode decays freely: 0 where its amplitude is
/// largest at the beginning of the record; else when its amplitude, taken over `length` seconds, leaves
/// the highest 5 %: after the rise of an impact, at the end of a plateau of driven vibration.
[[nodiscard]] double start_of_decay(std::span<const double> signal, double rate, double frequency,
                                    double length);

/// Whether the signal reached the end of a range: three times or more it stood still for three
/// samples at its largest or at its smallest value.
[[nodiscard]] bool looks_clipped(std::span<const double> signal);

}  // namespace microslip
