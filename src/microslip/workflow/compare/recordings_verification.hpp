// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/rig/verification/verification.hpp"
#include "microslip/rig/verification/verification_batch.hpp"
#include "microslip/workflow/compare/verification_draws.hpp"

/// @file
/// Recordings of a test against what a joint predicts.

namespace microslip {

/// Draws of a verification.
struct RecordingsDraws {
  DrawOptions options = {};                    ///< which of them
  std::string samples = {};                    ///< path of those of the joint; empty: none
  RigUncertainty rig = {};                     ///< how uncertain the rest is
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< reports the number done; may cancel
};

/// Inputs and options of verify_recordings().
struct RecordingsVerification {
  std::string rig;                        ///< path of rig.toml
  std::string joint;                      ///< path of joint.json
  std::vector<std::string> recordings;    ///< paths, one or more
  VerificationOptions verification = {};  ///< but what joint.json tells: coverage, linear damping
  RecordingReadOptions reading = {};      ///< of the recordings
  bool skip_faulty = false;               ///< leaves out what cannot be read or fitted
  std::optional<RecordingsDraws> draws = {};  ///< nothing: none
  Progress progress = {};                     ///< reports the records
};

/// Result of verify_recordings().
struct VerifiedRecordings {
  std::vector<NamedInput> inputs;              ///< rig and joint, as read
  std::size_t files;                           ///< of recordings
  Verifier verifier;                           ///< by the joint
  VerificationBatch batch;                     ///< may be without records
  std::vector<std::vector<Warning>> warnings;  ///< of the readers, one list a recording
  /// Nothing where no draws are asked for, or a record did not converge: they are not taken then.
  std::optional<VerificationSpread> spread = {};
};

/// @throws FileError, FormatError, InputError  as the readers and the verification, unless what is
///                                             faulty is skipped; those of the rig name its file;
///                                             as samples_for() and verification_spread().
/// @throws Cancelled  as the progress says.
[[nodiscard]] VerifiedRecordings verify_recordings(const RecordingsVerification& options);

/// The tables that are written; "-" is standard output, an empty path none.
struct VerificationTables {
  std::string table;      ///< one row per record and channel
  std::string harmonics;  ///< of each channel
  std::string histories;  ///< a few cycles of each channel
};

/// Those of the tables that have a path, for check_outputs().
[[nodiscard]] std::vector<PlannedOutput> planned(const VerificationTables& tables);

/// Adds the tables, that of the records with what draws make of them, each with version and
/// command, hashes of rig and joint, the linear damping that was used, and what is to be looked at.
/// @throws InputError  where no record is left. @throws FileError  as OutputFiles.
void add_tables(const VerifiedRecordings& verified, const VerificationTables& tables,
                const std::string& command, OutputFiles& files);

}  // namespace microslip
