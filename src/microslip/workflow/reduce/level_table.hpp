// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/io/output/provenance.hpp"

/// @file
/// A levels.csv as an identification takes it.

namespace microslip {

/// Far beyond every joint something else was measured or labelled, N/m.
inline constexpr double kSmallestStiffness = 1e-6;
inline constexpr double kLargestStiffness = 1e15;  ///< N/m

/// Treatment of levels of which a column `assembly` names several assemblies.
enum class AssemblyColumn {
  kUnsaid,   ///< not specified: refused, with the option `assemblies` as remedy
  kRefused,  ///< refused: levels of one joint are needed
  kIgnored,  ///< of one joint
  kUsed,     ///< of several; the names may not be empty
};

/// Options of level_table_of().
struct LevelTableOptions {
  /// Takes levels with inner reversals, too, whose D is not that of one loop [AR14 (7)].
  bool use_inner_reversals = false;
  LinearLossColumn linear_dissipation = LinearLossColumn::kIgnored;  ///< how W_lin is taken
  AssemblyColumn assemblies = AssemblyColumn::kUnsaid;  ///< how the column `assembly` is taken
  bool sources = false;                                 ///< whether `source` is read
};

/// The levels of a file.
struct LevelTable {
  NamedInput input;                        ///< as read
  LevelsFile used = {};                    ///< those to identify from
  std::vector<std::size_t> reversed = {};  ///< lines of those with inner reversals
  /// Of these; among `warnings`, too.
  std::optional<Warning> reversed_warning = {};
  std::vector<Warning> warnings = {};  ///< of flags and of inner reversals
};

/// @throws FormatError             as parse_levels(), at the cell that no joint can have, and where
///                                 all levels have inner reversals.
/// @throws InputError              where levels are of several assemblies and `assemblies` is not
///                                 specified.
[[nodiscard]] LevelTable level_table_of(NamedInput input, const LevelTableOptions& options = {});

/// Levels of a file, as above. @throws FileError, FormatError, InputError  as level_table_of().
[[nodiscard]] LevelTable read_level_table(const std::string& path,
                                          const LevelTableOptions& options = {});

}  // namespace microslip
