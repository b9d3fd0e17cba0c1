// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/signal/decay/decay_track.hpp"
#include "microslip/signal/decay/ring_down_result.hpp"

/// @file
/// From a track to the result with its warnings. Internal to signal.

namespace microslip {

/// The windows of a track with other points: those of several sensors together.
/// @param points  one per window.
/// @param flags   one per window, codes between blanks; those of the windows themselves are added.
[[nodiscard]] RingDown ring_down_of(const DecayTrack& track, const std::vector<DecayPoint>& points,
                                    std::vector<std::string> flags, const Dimension& measured,
                                    bool banded);

/// The warning of a second oscillation near the mode; none where there is none that counts.
[[nodiscard]] std::optional<Warning> warning_of_second(const DecayTrack& track);

/// The warning that the beginning of a decay is clipped; none where it is not.
[[nodiscard]] std::optional<Warning> warning_of_clipping(const DecayTrack& track);

/// Flags the windows of a track as long as a sensor, that of the track or another, is clipped.
void flag_clipped(const DecayTrack& sensor, const DecayTrack& track,
                  std::vector<std::string>& flags);

}  // namespace microslip
