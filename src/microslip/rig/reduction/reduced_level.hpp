// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"

/// @file
/// Level of a test, reduced from a steady record.

namespace microslip {

/// Flags that decide whether a level is used.
inline constexpr std::string_view kInnerReversals = "inner_reversals";
inline constexpr std::string_view kNegativeDissipation = "dissipation_negative";  ///< D < 0

/// A value with its standard deviation.
struct Measured {
  double value = 0.0;  ///< in the unit of what is measured
  double std = 0.0;    ///< 0 where it is not known
};

/// Level of one record.
struct ReducedLevel {
  std::string source;                ///< of the record
  double frequency = 0.0;            ///< of the cycle, as fitted, Hz
  double resonance_frequency = 0.0;  ///< of the structure at this amplitude, Hz
  double force_amplitude = 0.0;      ///< |F_1|, N
  double response_amplitude = 0.0;   ///< |A_1| at the exciter, m/s²
  Measured amplitude;                ///< A, half of the joint displacement peak to peak, m
  Measured dissipation;              ///< D = W_ext − W_lin, J [AR14 (15)]
  Measured input_energy;             ///< W_ext, J [AR14 (16)]
  /// W_ext by the sum over the samples, J [AR14 (17)]; where an accelerometer is at the exciter.
  std::optional<Measured> input_energy_by_sum = {};
  double linear_dissipation = 0.0;  ///< W_lin, J [AR14 (18), harmonic n counted n times]
  double damping_ratio = 0.0;       ///< ζ of the structure with the joint, 1; 0: not known
  std::optional<Measured> secant_stiffness = {};  ///< k_eq, N/m; none where k is not known
  /// Harmonics 2 … H of the force over the first, 1; less what the noise of the channel alone
  /// shows.
  double force_distortion = 0.0;
  std::size_t reversals = 2;  ///< of the joint displacement in a cycle
  double cycles = 0.0;        ///< in the record
  double misfit = 0.0;        ///< the worst of the accelerometers against the rig's motion, 1
  /// Faults to be checked, each once; `code` is shown in the column `flags` of levels.csv.
  std::vector<Warning> flags = {};

  /// Whether one of the flags has this code.
  [[nodiscard]] bool has_flag(std::string_view code) const;
};

}  // namespace microslip
