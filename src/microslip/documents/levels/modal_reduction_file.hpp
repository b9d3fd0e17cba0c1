// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/rig/reduction/modal_reduction.hpp"

namespace microslip {

/// modal_levels.csv of a reduction: `mode [1], displacement [m], frequency [Hz], dissipation [J],
/// dissipation_std [J], displacement_std [m], frequency_std [Hz]`, of each joint `amplitude_NAME
/// [m], dissipation_NAME [J], secant_stiffness_NAME [N/m]` each with `_std` behind it, `source,
/// drive_frequency [Hz], force_amplitude [N], input_energy [J], linear_dissipation [J],
/// force_distortion [1], flags`; flags stand between blanks.
///
/// For a joint that is not observed at some level, `unseen_NAME [1]` is the unobserved share of its
/// force, and its D and k_eq are not given; nor is its amplitude, unless it is known to 5 %
/// nevertheless: that of the model is given as `assumed_amplitude_NAME [m]`, with its standard
/// deviation.
/// @param levels   one at least. @param joints  their names.
/// @throws InputError  where there is no level, or a value is not finite.
[[nodiscard]] CsvWriter modal_reduction_table(std::span<const ModalLevel> levels,
                                              std::span<const std::string> joints);

}  // namespace microslip
