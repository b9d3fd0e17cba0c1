// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/cells/csv_writer.hpp"

/// @file
/// A path of the joint displacement as a table: `displacement [m]`, optional `normal_load [1]`;
/// with the answer of the joint, `force [N]`.

namespace microslip {

/// Displacement path and normal load imposed on a joint.
struct DisplacementPath {
  std::vector<double> displacement;  ///< x, m
  std::vector<double> normal_load;   ///< p = P_N/P_0, 1; ≥ 0; empty where it is constant
};

/// A path from the text of its table.
/// @throws FormatError  at the cell that breaks a rule.
[[nodiscard]] DisplacementPath parse_path(std::string text, std::string_view file);

/// parse_path() of a file; "-" is standard input. @throws FileError, FormatError
[[nodiscard]] DisplacementPath read_path(const std::string& path);

/// The table of a path with the forces on it.
/// @param path   of at least one point.
/// @param force  N; one per point of the path.
/// @throws InputError  where the lengths differ or a value is not finite.
[[nodiscard]] CsvWriter loop_table(const DisplacementPath& path, std::span<const double> force);

}  // namespace microslip
