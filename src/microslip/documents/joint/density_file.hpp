// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/cells/csv_writer.hpp"

/// @file
/// density.csv: a density at points, for plots: `slip_force [N]`, `density [1/N]` and, where its
/// uncertainty is known, `lower [1/N]`, `upper [1/N]`.

namespace microslip {

/// φ at slip forces f*, with a band. `lower` and `upper` are both there or both empty.
struct DensityTable {
  std::vector<double> slip_force;  ///< f*, N; ≥ 0, rising; twice the same at a step of φ
  std::vector<double> density;     ///< φ, 1/N; ≥ 0
  std::vector<double> lower;       ///< 1/N; ≥ 0
  std::vector<double> upper;       ///< 1/N; ≥ lower
};

/// A density from the text of its table.
/// @throws FormatError  at the cell that breaks a rule.
[[nodiscard]] DensityTable parse_density(std::string text, std::string_view file);

/// parse_density() of a file; "-" is standard input. @throws FileError, FormatError
[[nodiscard]] DensityTable read_density(const std::string& path);

/// The table of a density.
/// @throws InputError  where the lengths differ or a value is not finite.
[[nodiscard]] CsvWriter density_table(const DensityTable& density);

}  // namespace microslip
