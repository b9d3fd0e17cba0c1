// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The records that a joint was identified from, beside what the joint makes of their paths.

namespace microslip {

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
