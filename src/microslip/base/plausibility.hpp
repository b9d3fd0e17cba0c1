// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"

namespace microslip {

/// Amplitudes that no structure with joints survives. A value above is almost always a wrong unit.
inline constexpr double kLargestDisplacement = 1.0;  ///< m; seismic dampers end at some 0.5 m
/// m/s; 1 m at 160 Hz
inline constexpr double kLargestVelocity = 1e3;
inline constexpr double kLargestAcceleration = 1e6;  ///< m/s²; shock accelerometers end at 1e5 g
/// J per cycle; 1 MN over ±0.25 m, more than any one damper of a building takes
inline constexpr double kLargestDissipation = 1e6;

/// The warning `implausible_value` where an amplitude (an energy per cycle) is above its bound;
/// quantities without bound have none.
/// @param what       begins the text: "levels.csv, level 3".
/// @param dimension  of the amplitude.
/// @param amplitude  SI.
[[nodiscard]] std::optional<Warning> implausible_value(std::string_view what,
                                                       const Dimension& dimension,
                                                       double amplitude);

/// Checks the largest of several amplitudes and appends the warning, if any.
void warn_of_implausible(std::string_view what, const Dimension& dimension,
                         std::span<const double> amplitudes, std::vector<Warning>& warnings);

}  // namespace microslip
