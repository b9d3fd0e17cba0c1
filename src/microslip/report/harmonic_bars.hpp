// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "microslip/report/figure.hpp"

/// @file
/// Harmonics as bars on a logarithmic axis. Internal to report.

namespace microslip {

/// Which side of n the bar of harmonic n stands on.
enum class BarSide { kLeft, kRight };

/// Adds a bar from the lower end of the axis to heights[n − 1] beside each n, from n = 1.
void add_harmonic_bars(Figure& panel, std::span<const double> heights, BarSide side, int colour,
                       const std::string& legend);

/// From half a step below n = 1 to half a step above n = count.
[[nodiscard]] FigureAxis harmonic_axis(std::size_t count);

}  // namespace microslip
