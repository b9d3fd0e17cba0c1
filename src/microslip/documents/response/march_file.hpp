// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/dynamics/march/march.hpp"
#include "microslip/io/tables/table_column.hpp"

/// @file
/// march.csv, a march in time, one row a recorded time:
///
///     time [s]
///     force [N]           that acts; force at POINT [N] where there are several
///     displacement [m], velocity [m/s], acceleration [m/s^2]    at the response point
///     NAME displacement [m], NAME force [N]                     of each joint
///     absolute_displacement [m], absolute_velocity [m/s], absolute_acceleration [m/s^2]
///                         of the response point, where a base accelerates: with what that carries
///                         it along with, from rest on; the others are relative to the base
///
/// with `acceleration of BASE [m/s^2]` for the load on a base,
/// and, with draws, the limits of their band: `displacement_lower [m]`, `displacement_upper [m]`,
/// and those of each column after the loads.
///
/// Its comments state how the march ended, "NOT CONVERGED" where it did not, the estimated error,
/// where the energy went, and what warnings there were.

namespace microslip {

class TableStream;

/// The columns of what is marched, after the loads, in their order; one each of the signals of a
/// MarchRow.
[[nodiscard]] std::vector<TableColumn> march_columns(const JointedStructure& structure,
                                                     const LoadHistory& loads);

/// The table, written as the march goes, row by row: memory does not grow with their number. The
/// file appears whole or not at all.
class MarchTable {
 public:
  /// @param path       of the file; "-" is standard output, where the comments follow the rows.
  /// @param structure  that is marched.
  /// @param loads      that are marched; kept by reference.
  /// @param heading    the first comment; may be empty.
  /// @param with_band  whether each row has a band.
  /// @throws FileError  as OutputFiles.
  MarchTable(const std::string& path, const JointedStructure& structure, const LoadHistory& loads,
             std::string_view heading, bool with_band = false);
  MarchTable(const MarchTable&) = delete;
  MarchTable& operator=(const MarchTable&) = delete;
  ~MarchTable();

  /// Adds a row with one point. From the first on that is not finite none is written.
  /// @param row   of the march.
  /// @param band  lower and upper of each column after the forces, in their order; empty without.
  /// @throws FileError  where it cannot be written.
  void add(const MarchRow& row, std::span<const double> band = {});

  /// Writes the comments and gives the file its name. @param result  with all warnings.
  /// @throws FileError  where it cannot be written or replaced.
  void finish(const MarchResult& result);

 private:
  const LoadHistory& loads_;
  std::unique_ptr<TableStream> stream_;
  std::string line_;
  bool finite_ = true;
};

}  // namespace microslip
