// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/rig/reduction/reduction.hpp"

namespace microslip {

/// levels.csv of a reduction: the columns of levels_file.hpp, and `source, frequency [Hz],
/// resonance_frequency [Hz], force_amplitude [N], response_amplitude [m/s^2], input_energy [J],
/// linear_dissipation [J], force_distortion [1], reversals [1], flags`. Standard deviations and the
/// secant stiffness are columns where all levels have them; flags stand between blanks.
/// @throws InputError  where there is no level, or a value is not finite.
[[nodiscard]] CsvWriter reduction_table(std::span<const ReducedLevel> levels);

}  // namespace microslip
