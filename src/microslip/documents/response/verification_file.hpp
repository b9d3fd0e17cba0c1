// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/rig/verification/verification.hpp"

/// @file
/// The tables of a verification.

namespace microslip {

/// One row per record and channel: `source, channel, status, frequency [Hz], response_amplitude
/// [m/s^2], NRMSE [1], noise_share [1], amplitude_ratio [1], phase_error [rad]`, of the first
/// harmonic, predicted over recorded; then, the same in all rows of a record, `joint_amplitude [m],
/// predicted_joint_amplitude [m], input_energy [J], predicted_input_energy [J], frequency_offset
/// [Hz]`, a column where all records have one, and `flags`, with blanks between them.
/// @throws InputError  where there is no record, or a value is not finite.
[[nodiscard]] CsvWriter verification_table(std::span<const Verification> records);

/// One row per record and harmonic: `source, harmonic [1], frequency [Hz]`, and per channel, in its
/// unit, `<channel>_recorded, <channel>_recorded_phase [rad], <channel>_recorded_std,
/// <channel>_predicted, <channel>_predicted_phase [rad]`: of |c_n| cos(nωt + phase), with t = 0
/// where the first harmonic of the acceleration at the exciter is largest.
/// @param records  of one rig.
/// @throws InputError  as above.
[[nodiscard]] CsvWriter harmonics_table(std::span<const Verification> records);

/// One row a sample of the histories: `source, time [s]`, and for each channel, in its unit,
/// `<channel>_recorded, <channel>_predicted`. The prediction is drawn about mean and trend of the
/// recorded signal.
/// @param records  of one rig.
/// @throws InputError  as above.
[[nodiscard]] CsvWriter histories_table(std::span<const Verification> records);

}  // namespace microslip
