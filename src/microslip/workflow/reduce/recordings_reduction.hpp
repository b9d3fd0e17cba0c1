// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"
#include "microslip/workflow/reduce/measured_levels.hpp"

/// @file
/// Recordings of a test to levels.csv.

namespace microslip {

/// Inputs and options of reduce_recordings().
struct RecordingsReduction {
  std::string rig;                      ///< path of rig.toml
  std::vector<std::string> recordings;  ///< paths of records or of stepped-sine tables, one or more
  ReductionOptions reduction = {};      ///< of each
  RecordingReadOptions reading = {};    ///< of their files
  std::optional<NamedInput> rig_input = {};  ///< rig.toml, where it was read before
  std::vector<TestFile> opened = {};         ///< the recordings, where they were opened before
  bool skip_faulty = false;                  ///< leaves out what cannot be read or reduced
  Progress progress = {};                    ///< reports the records
};

/// Result of reduce_recordings().
struct ReducedRecordings {
  NamedInput rig;                              ///< as read
  std::vector<std::string> recordings;         ///< as asked for
  Reducer reducer;                             ///< of the rig
  ReductionBatch batch;                        ///< may be without levels
  std::vector<std::string> digests;            ///< SHA-256, one per recording; some may be empty
  std::vector<std::vector<Warning>> warnings;  ///< of the readers, one list a recording
};

/// @throws FileError, FormatError, InputError  as the readers and the reduction, unless what is
///                                             faulty is skipped; those of the rig name its file.
/// @throws Cancelled  as the progress says.
[[nodiscard]] ReducedRecordings reduce_recordings(const RecordingsReduction& options);

/// As levels.csv holds them. @param levels  with D > 0. @throws InputError  as its reader.
[[nodiscard]] MeasuredLevels measured_levels(std::span<const ReducedLevel> levels);

/// The text of levels.csv: levels with D ≥ 0, version and command, digests of what was read, and
/// warnings.
/// @throws InputError  where no level is left.
[[nodiscard]] std::string levels_text(const ReducedRecordings& reduced, const std::string& command);

}  // namespace microslip
