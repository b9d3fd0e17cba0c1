// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/assemblies/assemblies.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// Tables of levels of several assemblies of a joint.

namespace microslip {

/// How densities.csv calls the middle of the assemblies. No assembly is called so.
inline constexpr std::string_view kCommonDensity = "common";

/// How densities.csv calls the assembly that comes next. No assembly is called so.
inline constexpr std::string_view kNextAssembly = "next";

/// Key that distinguishes the assemblies.
enum class AssembliesBy {
  kColumn,  ///< the column `assembly` of the files
  kFiles,   ///< each file is one, called as the file is
};

/// The levels of all assemblies, in the order in which they come.
struct AssemblyLevels {
  std::vector<Assembly> assemblies = {};  ///< with k of their own where the files tell it
  std::vector<std::size_t> count = {};    ///< levels of each that are used
  std::vector<InputHash> inputs = {};     ///< the files
  std::vector<Warning> warnings = {};     ///< of flags and inner reversals
};

/// @param paths                of levels.csv.
/// @param by                   what tells assemblies apart.
/// @param use_inner_reversals  as LevelTableOptions.
/// @throws FileError, FormatError  as read_level_table(); where a name is empty, or k of one
///                                 assembly has two values.
/// @throws InputError  where there is no column `assembly`, or one that files make needless; where
///                     a name is no name of a file.
[[nodiscard]] AssemblyLevels read_assembly_levels(const std::vector<std::string>& paths,
                                                  AssembliesBy by, bool use_inner_reversals);

}  // namespace microslip
