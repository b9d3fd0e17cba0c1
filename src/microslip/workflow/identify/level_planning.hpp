// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "microslip/base/progress.hpp"

/// @file
/// Which levels are to be planned, and for what.

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Quantity whose uncertainty further levels reduce.
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

/// Inputs and options of plan_levels().
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
  Progress progress = {};    ///< reports the draws, also those of a peak; may cancel

  /// More are a mistake.
  static constexpr std::size_t kMostDraws = 100'000;
};

}  // namespace microslip
