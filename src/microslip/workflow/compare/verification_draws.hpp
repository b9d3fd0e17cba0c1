// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/dynamics/draws/drawn_joints.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/rig/verification/verification.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Draws of a joint and its rig at recordings: which of what was measured lies within.

namespace microslip {

/// How uncertain the rig of a verification is: relative standard deviations, as of StructureSpread.
struct RigUncertainty {
  double frequency = 0.0;          ///< of each mode by itself
  double loss_factor = 0.0;        ///< as above
  double normal_load = 0.0;        ///< of what scales the slip forces
  double force_gain = 0.0;         ///< of the reading of the force
  double acceleration_gain = 0.0;  ///< of the readings of all accelerometers alike
};

/// Measured and predicted values, and the band of the draws.
struct CheckedValue {
  double recorded = 0.0;   ///< of the record
  double predicted = 0.0;  ///< by the joint itself
  double lower = 0.0;      ///< of the draws
  double upper = 0.0;      ///< as above

  /// Whether what was measured lies between them.
  [[nodiscard]] bool inside() const { return recorded >= lower && recorded <= upper; }
};

/// A record and what the draws say of it.
struct CheckedRecord {
  CheckedValue response;      ///< at the exciter with the recorded force and phase, m/s²
  CheckedValue frequency;     ///< of that vibration, Hz
  CheckedValue amplitude;     ///< A of the joint, at the recorded frequency and response, m
  CheckedValue input_energy;  ///< W_ext of the same, J
};

/// Results of the draws of a verification.
struct VerificationSpread {
  std::vector<CheckedRecord> records;  ///< in the order of the records
  DrawsTaken taken;                    ///< what became of the draws
  std::string uncertain;               ///< in words
  std::vector<Warning> warnings;       ///< what must be known of the bands

  /// How many records have a value inside.
  [[nodiscard]] std::size_t inside(CheckedValue CheckedRecord::*value) const;
};

/// Predicts each record by each draw.
///
/// A reading is gain times what is there: a draw of gains g_F, g_a vibrates with a_1/g_a where a_1
/// is read, takes the force F that reads as g_F F, and has g_F g_a W_ext for the energy that such
/// readings give. The amplitude of the joint is compared with that of accelerometers, g_a A, or,
/// where a vibrometer sees it, with A. A draw fails where it does not converge at one of the
/// records, or has its recorded phase nowhere within 20 % of the recorded frequency.
///
/// @param verifier   by the joint.
/// @param records    of it, all converged.
/// @param joint      draws of the joint; without any it is certain but for its normal load.
/// @param rig        how uncertain the rest is.
/// @param options    which draws, and the confidence.
/// @param execution  of the draws.
/// @param progress   reports the draws done; may cancel.
/// @throws InputError  as DrawOptions::check(); where nothing is uncertain, no record is there, one
///                     did not converge or has no peak by the joint itself, or all draws failed.
/// @throws Cancelled   as progress says.
[[nodiscard]] VerificationSpread verification_spread(
    const Verifier& verifier, const std::vector<Verification>& records, JointDraws joint,
    const RigUncertainty& rig, const DrawOptions& options,
    const Execution& execution = Execution::threads(), const Progress& progress = {});

/// Adds to verification_table(), in all rows of a record: `predicted_response [m/s^2]`,
/// `predicted_frequency [Hz]`, then NAME_lower, NAME_upper of these, of `predicted_joint_amplitude`
/// and `predicted_input_energy`, and `response_inside [1]`, `frequency_inside [1]`,
/// `joint_amplitude_inside [1]`, `input_energy_inside [1]`: 1 where what was measured lies between.
/// @param spread   of the records.
/// @param records  of the table.
/// @param table    with one row per record and channel.
void add_checked(const VerificationSpread& spread, const std::vector<Verification>& records,
                 CsvWriter& table);

/// Comments of the table: the draws, and how many records lie inside.
[[nodiscard]] std::string checked_comment(const VerificationSpread& spread);

/// The lines of a summary on the draws.
[[nodiscard]] std::string describe_checked(const VerificationSpread& spread);

}  // namespace microslip
