// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"
#include "microslip/workflow/reduce/measured_levels.hpp"
#include "microslip/workflow/reduce/reduction_inputs.hpp"

/// @file
/// Recordings of a test to levels.csv.

namespace microslip {

/// Result of reduce_recordings().
struct ReducedRecordings {
  NamedInput rig;                              ///< as read
  std::vector<std::string> recordings;         ///< as asked for
  Reducer reducer;                             ///< of the rig
  ReductionBatch batch;                        ///< may be without levels
  std::vector<std::string> digests;            ///< SHA-256, one per recording; some may be empty
  std::vector<std::vector<Warning>> warnings;  ///< of the readers, one list a recording
};

/// @param inputs   with a rig.toml.
/// @param options  of each recording.
/// @throws FileError, FormatError, InputError  as the readers and the reduction, unless what is
///                                             faulty is skipped; those of the rig name its file.
/// @throws Cancelled  as the progress says.
[[nodiscard]] ReducedRecordings reduce_recordings(const ReductionInputs& inputs,
                                                  const ReductionOptions& options = {});

/// As levels.csv holds them. @param levels  with D > 0. @throws InputError  as its reader.
[[nodiscard]] MeasuredLevels measured_levels(std::span<const ReducedLevel> levels);

/// The text of levels.csv: levels with D ≥ 0, version and command, digests of what was read, and
/// warnings.
/// @throws InputError  where no level is left.
[[nodiscard]] std::string levels_text(const ReducedRecordings& reduced, const std::string& command);

}  // namespace microslip
