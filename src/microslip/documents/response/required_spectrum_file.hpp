// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/signal/shock/shock_synthesis.hpp"

namespace microslip {

/// A table of a required shock response spectrum: `frequency [Hz]`, rising, and `maximax [m/s^2]`,
/// or in g; log-log interpolation between its rows. A table that `spectrum` wrote is one. "-" is
/// standard input.
/// @throws FileError, FormatError  naming file, line and column. @throws InputError
[[nodiscard]] RequiredSpectrum read_required_spectrum(const std::string& path);

}  // namespace microslip
