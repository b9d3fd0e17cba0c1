// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/report/drawing/figure.hpp"

/// @file
/// Parts that figures of harmonics share. Internal to report.

namespace microslip {

/// Axis of harmonics with room for the bars of the first and the last one.
[[nodiscard]] FigureAxis harmonic_axis(std::size_t first, std::size_t last);

/// The line of the distortion that a controlled force may have, %. [AR14]
[[nodiscard]] LineLayer one_percent(double from, double to);

}  // namespace microslip
