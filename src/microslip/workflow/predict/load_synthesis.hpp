// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/base/progress.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/signal/shock/load_shapes.hpp"
#include "microslip/signal/shock/shock_synthesis.hpp"

/// @file
/// Loads that tests and specifications know, on what drives a model: what `load` writes and `march`
/// takes.

namespace microslip {

/// The shape of a load over time.
enum class LoadShape : std::uint8_t { kSine, kSweep, kHalfSine, kNoise, kShock };

/// "sine", "sweep", "half-sine", "noise", "shock".
[[nodiscard]] std::string_view to_string(LoadShape shape);

/// A load to be made. What a shape does not know must be left out.
struct LoadPlan {
  LoadShape shape = LoadShape::kSine;  ///< over time
  double peak = 0.0;  ///< amplitude of what drives, N or m/s²; > 0; of noise and shock not given
  double frequency = 0.0;             ///< of a sine, the first of a sweep, Hz
  double last_frequency = 0.0;        ///< of a sweep, Hz
  bool logarithmic = false;           ///< of a sweep: equal ratios in equal times
  std::optional<double> cycles = {};  ///< of a sine: it ends after so many
  double pulse = 0.0;                 ///< length of a half-sine or shock, s; 0: shortest_shock()
  double begin = 0.0;                 ///< of a half-sine or shock, s
  PowerDensity density = {};          ///< of noise, N²/Hz or (m/s²)²/Hz
  RequiredSpectrum required = {};     ///< of a shock
  ShockOptions shock = {};  ///< but length, sampling rate and seed, which are those of here
  std::uint64_t seed = 1;   ///< of noise or of a shock
  double duration = 0.0;    ///< of all, s
  /// Hz; 0: 256 times per period of the highest sine, 200 times a pulse, 32 times per period of the
  /// highest frequency of noise, 20 times of a shock. Between the times loads are straight.
  double sampling_rate = 0.0;
};

/// A load, and how it was found.
struct SynthesisedLoad {
  LoadHistory history;                    ///< what `march` takes
  std::optional<SynthesizedShock> shock;  ///< of a shock; from its own begin on

  /// Whether it is what was asked for.
  [[nodiscard]] bool converged() const { return !shock || shock->summary.converged(); }
};

/// The load on each excitation of a structure: of a sine with all its harmonics and phases, of the
/// others times its first harmonic. Noise of several excitations is independent.
/// @param structure  its excitations and bases. @param plan  of the load.
/// @param progress   of the synthesis of a shock.
/// @throws InputError  for values out of their range; for shapes other than a sine where a first
///                     harmonic is 0 or has a phase other than 0 and π; where an excitation is
///                     named twice; for a shock of a structure whose base is not driven.
[[nodiscard]] SynthesisedLoad synthesise_load(const JointedStructure& structure,
                                              const LoadPlan& plan, const Progress& progress = {});

/// The lines of a summary: loads and their places, peaks and rms, and the deviation of a shock from
/// its spectrum.
[[nodiscard]] std::string describe_load(const JointedStructure& structure,
                                        const SynthesisedLoad& load);

/// Notes on the table, one line per fact; empty but for a shock.
[[nodiscard]] std::string load_comment(const LoadPlan& plan, const SynthesisedLoad& load);

}  // namespace microslip
