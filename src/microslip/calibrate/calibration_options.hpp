// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance_options.hpp"

namespace microslip {

/// Use of the frequencies of levels.
enum class FrequencyUse {
  /// Their change over the levels of each mode in each session: the structure may have a frequency
  /// offset.
  kChange,
  kAbsolute,  ///< their values: the modes of the structure are exact
  kIgnore,    ///< nothing
};

/// "change", "absolute", "ignore".
[[nodiscard]] std::string_view to_string(FrequencyUse use);

/// The least number of levels that calibrate() needs per joint sought.
inline constexpr std::size_t kFewestModalLevels = 4;

/// Options of calibrate().
struct CalibrationOptions {
  FrequencyUse frequency = FrequencyUse::kChange;  ///< how frequencies are used
  /// Identifies k of the joints too; needs FrequencyUse::kAbsolute.
  bool fit_stiffness = false;
  /// Takes the displacements of the joints from the shapes of the stuck structure. For comparison:
  /// shapes change as joints slip.
  bool stuck_shapes = false;
  /// Seeks slip forces at which a density jumps; 20 levels for each joint are needed.
  bool edges = true;
  /// Corrects the modes by their measured offsets while joints are found, with
  /// FrequencyUse::kChange.
  bool correct_modes = true;
  HarmonicBalanceOptions balance = {};  ///< harmonics and excitation
  int coefficients = 40;                ///< of the density of each joint; ≥ 10
  std::size_t draws = 1000;             ///< of the posterior; ≥ 100
  double confidence = 0.95;             ///< of the bands, in (0, 1)
  std::uint64_t seed = 1;               ///< of the draws
  /// Names of the levels in warnings; empty: "level 3", by their order from 1.
  std::vector<std::string> level_names = {};
  Progress progress = {};                      ///< of all the work
  Execution execution = Execution::threads();  ///< of the levels

  /// @throws InputError  naming the option that breaks a rule.
  void check() const;
};

}  // namespace microslip
