// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/inversion/level_design.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/identify/level_planning.hpp"

/// @file
/// levels.csv to the levels that are to be measured next.

namespace microslip {

/// Levels to be measured next.
struct LevelPlan {
  NamedInput input;                      ///< the levels as read
  std::size_t used = 0;                  ///< levels that the plan rests on
  std::vector<double> amplitude = {};    ///< that were to choose from, m
  std::pair<double, double> range = {};  ///< of slip forces, N; of a peak not used
  std::size_t draws = 0;                 ///< that it rests on
  double peak_frequency = 0.0;           ///< of the joint found so far, Hz
  double peak_height = 0.0;              ///< m, as above
  LevelDesign design = {};               ///< of kWidths standard deviations each
  std::vector<Warning> warnings = {};    ///< of levels, identification and plan
};

/// Levels fewer than these are no base for a plan.
inline constexpr std::size_t kFewestToPlan = 8;

/// A plan of the levels that lower the expected width of the target most: see design_levels().
/// Widths hold 95 %: 3.92 standard deviations; of a density their mean over the range. Errors that
/// all levels share are not in them: no further level corrects them.
/// @throws FileError, FormatError  as read_level_table() and read_model().
/// @throws InputError  for values out of their range; for fewer levels than kFewestToPlan; where
///                     the model has no such joint, or one of another stiffness, or no peak in the
///                     range.
/// @throws Cancelled   as the progress says.
[[nodiscard]] LevelPlan plan_levels(const LevelPlanning& options);

/// The table: rank, amplitude, repeats, expected widths. What must be known of it, and where more
/// of the same no longer helps, stands in its comments.
[[nodiscard]] std::string plan_text(const LevelPlan& plan, const LevelPlanning& options,
                                    std::string_view command);

/// The same in words.
[[nodiscard]] std::string describe_plan(const LevelPlan& plan, const LevelPlanning& options);

}  // namespace microslip
