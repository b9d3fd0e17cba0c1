// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/observe/levels.hpp"

/// @file
/// levels.csv: one row per level. Needed: `amplitude [m]`, `dissipation [J]`. Optional:
/// `amplitude_std [m]`, `dissipation_std [J]`, `secant_stiffness [N/m]`, `secant_stiffness_std
/// [N/m]`, `resonance_frequency [Hz]` or else `frequency [Hz]` with the same name and `_std`,
/// `reversals [1]` of the joint displacement in a cycle, `flags`, and `assembly`, the name of the
/// assembly that a level was measured on; of several assemblies also `stiffness [N/m]`, k of each.
/// Other columns are left alone.

namespace microslip {

/// Levels in the order of the file, with the place of each.
struct LevelsFile {
  Levels levels;                           ///< in the order of the file
  std::string file;                        ///< its name, for messages
  std::vector<std::size_t> line;           ///< one per level, from 1
  std::vector<double> reversals;           ///< one per level, 1; empty where not given
  std::vector<std::string> flags = {};     ///< one per level, separated by blanks; empty if none
  std::vector<std::string> assembly = {};  ///< one per level; empty where not given
  std::vector<double> stiffness = {};      ///< k of the assembly of a level, N/m; if asked for
  std::vector<std::string> source = {};  ///< record of a level; if asked for, empty where not given

  /// D determines the density where the joint reverses twice per cycle; with inner reversals it
  /// includes the loss of inner loops too [AR14 (7)].
  [[nodiscard]] bool has_inner_reversals(std::size_t level) const {
    return !reversals.empty() && reversals[level] > 2.0;
  }

  /// The lines of the levels with inner reversals.
  [[nodiscard]] std::vector<std::size_t> lines_with_inner_reversals() const;
};

/// The file without the levels that have inner reversals.
[[nodiscard]] LevelsFile without_inner_reversals(const LevelsFile& file);

/// Use of the column `linear_dissipation [J]`, W_lin.
enum class LinearLossColumn {
  kIgnored,  ///< not read
  kUsed,     ///< read where present
  kNeeded,   ///< required
};

/// Options of parse_levels(): columns in addition to those of every identification.
struct LevelsReadOptions {
  LinearLossColumn linear_dissipation = LinearLossColumn::kIgnored;  ///< how W_lin is taken
  bool assemblies = false;  ///< no name in `assembly` is empty; `stiffness [N/m]` is read
  bool sources = false;     ///< `source` is read
};

/// Levels from the text of a levels.csv.
/// @throws FormatError  at the cell that breaks a rule: A > 0, D ≥ 0, k_eq > 0, W_lin ≥ 0, f > 0,
///                      σ ≥ 0, all finite.
[[nodiscard]] LevelsFile parse_levels(std::string text, std::string_view file,
                                      const LevelsReadOptions& options = {});

/// parse_levels() of a file; "-" is standard input. @throws FileError, FormatError
[[nodiscard]] LevelsFile read_levels(const std::string& path);

/// The columns of the levels; more may be added before it is written.
/// @throws InputError  where the lengths differ or a value is not finite.
[[nodiscard]] CsvWriter levels_table(const Levels& levels);

}  // namespace microslip
