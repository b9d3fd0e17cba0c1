// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/identify/assemblies/assemblies.hpp"
#include "microslip/workflow/identify/assembly_levels.hpp"
#include "microslip/workflow/identify/calibration.hpp"

/// @file
/// Levels of several assemblies, to the folder of what was found.

namespace microslip {

/// Inputs and options of identify_read_assemblies().
struct AssembliesIdentification {
  std::vector<std::string> levels = {};     ///< paths of levels.csv
  AssembliesBy by = AssembliesBy::kColumn;  ///< what tells assemblies apart
  std::optional<double> stiffness = {};  ///< k of all, N/m, where assemblies have none of their own
  AssembliesOptions options = {};        ///< of the method
  bool use_inner_reversals = false;      ///< of the levels, as LevelTableOptions
  std::string out = {};                  ///< folder of the results
  std::string command = {};              ///< that the files are made by
};

/// Result of identify_read_assemblies().
struct IdentifiedAssemblies {
  AssemblyLevels read = {};            ///< the levels
  AssembliesResult found = {};         ///< with warnings of the files, too
  std::vector<ResultFile> files = {};  ///< joint.json, joint_samples.h5, assembly_NAME.json …
};

/// Reads the levels, and checks what can be before anything is computed or written.
/// @throws FileError, FormatError, InputError  as read_assembly_levels(); for too few assemblies;
///                                             where `out` is no folder to write to.
[[nodiscard]] IdentifiedAssemblies read_assemblies(const AssembliesIdentification& options);

/// Identifies, and composes the files.
/// @param options  as for read_assemblies().
/// @param done     what that gave; the rest is added.
/// @throws InputError  as identify_assemblies(). @throws Cancelled  as the progress says.
void identify_read_assemblies(const AssembliesIdentification& options, IdentifiedAssemblies& done);

/// The summary.
[[nodiscard]] std::string describe_assemblies(const AssembliesIdentification& options,
                                              const IdentifiedAssemblies& done);

}  // namespace microslip
