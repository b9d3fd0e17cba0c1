// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// @file
/// Which part of a record is free decay. Internal to signal.

namespace microslip {

/// The time of a blow, s from the first sample: where the signal as it was recorded, unfiltered,
/// first reaches a tenth of its largest value. A filter for one mode would ring before it. Nothing
/// where the record is not quiet until then (an rms of 2 % of the largest value), or begins with
/// it.
[[nodiscard]] std::optional<double> find_blow(std::span<const double> signal, double rate);

/// The time, s from the first sample, from which a mode decays freely: 0 where its amplitude at the
/// beginning of the record is within `margin` of its largest; else when its amplitude, taken over
/// `length` seconds, leaves the highest 5 %: after the rise of an impact, at the end of a plateau
/// of driven vibration.
/// @param margin  relative, ≥ 0: apparent rise of the amplitude by other modes.
[[nodiscard]] double start_of_decay(std::span<const double> signal, double rate, double frequency,
                                    double length, double margin = 0.0);

/// Whether the signal reached the end of a range: three times or more it stayed for three samples
/// at its largest or at its smallest value.
[[nodiscard]] bool looks_clipped(std::span<const double> signal);

}  // namespace microslip
