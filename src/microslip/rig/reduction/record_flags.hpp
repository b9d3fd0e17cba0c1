// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/reduction/fitted_record.hpp"

/// @file
/// Flags of a record, whatever it is reduced to. Internal to rig.

namespace microslip {

/// Adds a flag unless there is one of its code already.
void add_flag_once(std::vector<Warning>& flags, std::string_view code, std::string_view text);

/// Harmonics 2 … H of the force over the first, 1, less what noise alone makes of them.
[[nodiscard]] double force_distortion_of(const FourierSeries& force,
                                         std::span<const double> harmonic_std);

/// force_distortion. @param most  without the flag.
void flag_force_distortion(std::vector<Warning>& flags, double distortion, double most);

/// phase_unsteady, spike, few_cycles, uneven_sampling, and those of signal_quality() and the fit.
/// @param most_phase  rad; of a cycle against the whole record without a flag.
void flag_record(std::vector<Warning>& flags, const FittedRecord& record, double most_phase);

}  // namespace microslip
