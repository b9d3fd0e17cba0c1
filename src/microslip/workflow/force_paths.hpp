// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/observe/record_evidence.hpp"
#include "microslip/workflow/experiment_results.hpp"

/// @file
/// The records that a joint was identified from, beside what the joint makes of their paths.

namespace microslip {

/// The force of a joint at each sample of a record, N, with the offset of its group: the mean of
/// what was measured more than the joint has. NaN where the state of the joint is not known.
/// @param evidence  of the record.
/// @param joint     that was identified.
/// @param viscous   c of a viscous part beside it, N s/m; 0 for none.
[[nodiscard]] std::vector<double> found_force(const RecordEvidence& evidence, const Joint& joint,
                                              double viscous);

/// The records that were found, and what kept others from it.
struct ForcePaths {
  std::vector<ForcePath> paths = {};   ///< in the order of their numbers
  std::vector<SourceFile> files = {};  ///< that they were read from
  std::vector<Warning> warnings = {};  ///< of records that are missing or changed
};

/// Reads records that a joint.json was identified from: by the names that its provenance has, in
/// the folder, in recordings/ of it, or where the call found them; the same by their SHA-256.
/// @param file     of the joint, with what its identification says.
/// @param folder   that it lies in.
/// @param records  numbers of those that are wanted, from 0; others are not read.
/// @param progress  of the records read.
/// @throws Cancelled
[[nodiscard]] ForcePaths read_force_paths(const JointFile& file, const std::string& folder,
                                          std::span<const std::size_t> records,
                                          const Progress& progress = {});

}  // namespace microslip
