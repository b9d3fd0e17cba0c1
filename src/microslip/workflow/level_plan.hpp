// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/identify/level_design.hpp"
#include "microslip/workflow/provenance.hpp"

/// @file
/// levels.csv to the levels that are to be measured next.

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// What further levels are to tell.
enum class PlanTarget {
  kDensity,  ///< φ over a range of slip forces
  kArea,     ///< ∫φ df* over it, the share of k that slips there
  kPeak,     ///< the height of a resonance peak of a structure with the joint
};

#pragma GCC diagnostic pop

/// The peak that is to be predicted: the highest of a frequency response.
struct PlannedPeak {
  std::string model =
      {};  ///< path of model.toml; the joint that is measured takes the place of its
           ///< own
  std::string joint = {};  ///< name of that; needed where there are several
  double force = 0.0;      ///< amplitude of the force, N
  double from = 0.0;       ///< Hz
  double to = 0.0;         ///< Hz
};

/// What is to be planned, and how.
struct LevelPlanning {
  std::string levels = {};                   ///< path of levels.csv; "-" is standard input
  double stiffness = 0.0;                    ///< k of the stuck joint, N/m; > 0
  PlanTarget target = PlanTarget::kDensity;  ///< what levels are to tell
  PlannedPeak peak = {};                     ///< of kPeak
  std::size_t count = 5;                     ///< how many levels are sought; 1 to kMostDesigned
  /// Between which they may lie, m; without it the lowest and highest that are there.
  std::optional<std::pair<double, double>> amplitude = {};
  /// Of slip forces, N, of kDensity and kArea; without it k times those amplitudes.
  std::optional<std::pair<double, double>> range = {};
  std::size_t draws = 1000;  ///< of the posterior; 100 to kMostDraws
  std::uint64_t seed = 1;    ///< of them
  Progress progress = {};    ///< told of the draws, and of those of a peak; may cancel

  /// More are a mistake.
  static constexpr std::size_t kMostDraws = 100'000;
};

/// Levels to be measured next.
struct LevelPlan {
  NamedInput input;                      ///< the levels as read
  std::size_t used = 0;                  ///< levels that the plan rests on
  std::vector<double> amplitude = {};    ///< that were to choose from, m
  std::pair<double, double> range = {};  ///< of slip forces, N; of a peak not used
  std::size_t draws = 0;                 ///< that it rests on
  double peak_frequency = 0.0;           ///< of the joint found so far, Hz
  double peak_height = 0.0;              ///< likewise, m
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
