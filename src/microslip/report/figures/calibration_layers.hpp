// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/report/drawing/figure.hpp"
#include "microslip/workflow/identify/calibration_results.hpp"

/// @file
/// Modes and joints as layers, in SI units. Internal to report.

namespace microslip {

/// The levels determine a density where the variance reduction is this or more, 1.
inline constexpr double kDetermined = 0.5;

/// The stroke of the line of a mode or joint, from 0: another colour and another style each.
[[nodiscard]] Stroke stroke_of(std::size_t index);

/// A density with its band, which is grey where `variance_reduction` is below kDetermined.
/// @param index  of the joint. @param legend  of the line.
[[nodiscard]] std::vector<Layer> density_layers(const DensityFound& joint, std::size_t index,
                                                const std::string& legend);

/// Rows of a mode, by rising displacement.
struct RowsOfMode {
  std::size_t mode = 0;           ///< from 1
  std::vector<std::size_t> rows;  ///< of the levels
};

/// The modes by their number.
[[nodiscard]] std::vector<RowsOfMode> rows_by_mode(const LevelsOfModes& levels);

/// Marks of each mode over the displacement, as far as they are finite.
/// @param values  one per level. @param std  none, or one per level.
void add_marks(std::vector<Layer>& layers, const LevelsOfModes& levels,
               const std::vector<double>& values, const std::vector<double>& std = {});

/// A line of each mode over the displacement.
void add_lines(std::vector<Layer>& layers, const LevelsOfModes& levels,
               const std::vector<double>& values);

/// A band of each mode over the displacement, without a legend: it goes with its line.
void add_bands(std::vector<Layer>& layers, const LevelsOfModes& levels,
               const std::vector<double>& lower, const std::vector<double>& upper);

}  // namespace microslip
