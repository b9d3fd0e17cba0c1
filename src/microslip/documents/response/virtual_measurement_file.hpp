// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"

/// @file
/// The tables of a virtual test, one row per converged level; the others are comments.

namespace microslip {

/// Exact results for the reduction of the records: the columns of reduction_table(), without
/// standard deviations, and `mean_displacement [m]` of the joint. The secant stiffness is k_eq(A)
/// of the joint (joint/secant.hpp), the resonance that of phase resonance under a pure force, the
/// flags are the warnings of the level.
/// @param levels   of the test, all of them.
/// @param joint    of the test.
/// @param sources  the name of each level's record.
/// @throws InputError  where no level was found, or the number of sources differs.
[[nodiscard]] CsvWriter truth_table(std::span<const VirtualLevel> levels, const Joint& joint,
                                    std::span<const std::string> sources);

/// History of the force control: `level, response_amplitude [m/s^2], frequency [Hz],
/// control_iterations [1], force_before [N], force_after [N]` of the fundamental, and `before_n
/// [1], after_n [1]`, n = 2 … N, the harmonics of the force over the fundamental. "Before" is under
/// a sinusoidal voltage. [AR14 Fig. 7]
/// @param levels     of the test, all of them.
/// @param harmonics  N.
/// @throws InputError  where no level was found, or the levels have no shaker.
[[nodiscard]] CsvWriter force_control_table(std::span<const VirtualLevel> levels,
                                            std::size_t harmonics);

}  // namespace microslip
