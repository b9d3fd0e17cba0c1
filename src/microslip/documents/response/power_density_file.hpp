// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/units.hpp"
#include "microslip/signal/shock/load_shapes.hpp"

namespace microslip {

/// A table of a power spectral density: `frequency [Hz]`, rising, and `density [N^2/Hz]` of a
/// force, `density [g^2/Hz]` or `density [(m/s^2)^2/Hz]` of an acceleration; straight in logarithms
/// between its rows. "-" is standard input.
/// @param path  of the table.
/// @param of    what the density is of: kForce, kAcceleration.
/// @throws FileError, FormatError  naming file, line and column. @throws InputError
[[nodiscard]] PowerDensity read_power_density(const std::string& path, const Dimension& of);

}  // namespace microslip
