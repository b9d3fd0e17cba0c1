// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/dynamics/march.hpp"
#include "microslip/signal/load_shapes.hpp"

/// @file
/// Loads that tests and specifications know, on what drives a model: what `load` writes and `march`
/// takes.

namespace microslip {

/// The shape of a load over time.
enum class LoadShape : std::uint8_t { kSine, kSweep, kHalfSine, kNoise };

/// "sine", "sweep", "half-sine", "noise".
[[nodiscard]] std::string_view to_string(LoadShape shape);

/// A load to be made. What a shape does not know must be left out.
struct LoadPlan {
  LoadShape shape = LoadShape::kSine;  ///< over time
  double peak = 0.0;            ///< amplitude of what drives, N or m/s²; > 0; of noise not given
  double frequency = 0.0;       ///< of a sine, the first of a sweep, Hz
  double last_frequency = 0.0;  ///< of a sweep, Hz
  bool logarithmic = false;     ///< of a sweep: equal ratios in equal times
  std::optional<double> cycles = {};  ///< of a sine: it ends after so many
  double pulse = 0.0;                 ///< length of a half-sine, s
  double begin = 0.0;                 ///< of a half-sine, s
  PowerDensity density = {};          ///< of noise, N²/Hz or (m/s²)²/Hz
  std::uint64_t seed = 1;             ///< of noise
  double duration = 0.0;              ///< of all, s
  /// Hz; 0: 256 times a period of the highest sine, 200 times a pulse, 32 times a period of the
  /// highest frequency of noise. Between the times loads are straight.
  double sampling_rate = 0.0;
};

/// The load on each excitation of a structure: of a sine with all its harmonics and phases, of the
/// others times its first harmonic. Noise of several excitations is independent.
/// @throws InputError  for values out of their range; for shapes other than a sine where a first
///                     harmonic is 0 or has a phase other than 0 and π; where an excitation is named
///                     twice.
[[nodiscard]] LoadHistory make_load(const JointedStructure& structure, const LoadPlan& plan);

/// The lines of a summary: what acts where, peaks and rms.
[[nodiscard]] std::string describe_load(const JointedStructure& structure, const LoadHistory& load);

}  // namespace microslip
