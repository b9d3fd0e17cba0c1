// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/observe/levels.hpp"
#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// A closed cycle of a path: from a turn a to a turn b and back to a, without the closed cycles
/// inside of it, which a joint forgets once they close (Madelung). So each has two turns, and for a
/// Masing joint
///
///     A    = ½|a − b|
///     D    = ∮ F du
///     k_eq = (1/(πA)) ∮ F cos θ dθ,   u = ½(a + b) + A cos θ
///
/// are those of secant.hpp and dissipation.hpp: the force of such a joint depends on where it is on
/// the branch and not on when, so that k_eq is that of a sine of amplitude A whatever the waveform
/// of the path. Both integrals are exact for a force that is straight in u between samples.
struct RecordCycle {
  std::size_t first = 0;   ///< sample of the turn a
  std::size_t turn = 0;    ///< that of b
  std::size_t last = 0;    ///< where the path is at a again, or turns beside it
  std::size_t inner = 0;   ///< closed cycles inside, which were removed
  std::size_t points = 0;  ///< remaining samples

  double amplitude = 0.0;               ///< A, m
  double amplitude_std = 0.0;           ///< m
  double dissipation = 0.0;             ///< D, J
  double dissipation_std = 0.0;         ///< J
  double secant_stiffness = 0.0;        ///< k_eq, N/m
  double secant_stiffness_std = 0.0;    ///< N/m
  double mean_displacement = 0.0;       ///< ½(a + b), m
  double mean_force = 0.0;              ///< ½(F(a) + F(b)), N
  double gap = 0.0;                     ///< F at a after the cycle less that before it, N
  std::vector<std::string> flags = {};  ///< codes below

  /// Whether it has that flag.
  [[nodiscard]] bool has_flag(std::string_view code) const;
};

/// Flags of cycles.
inline constexpr std::string_view kNotClosed = "not_closed";  ///< F at a differs from before
inline constexpr std::string_view kMeanMoves = "mean_moves";  ///< similar cycles drift to one side
inline constexpr std::string_view kOneLoop = "one_loop";      ///< no range before it, or behind it
inline constexpr std::string_view kFewSamples =
    "few_samples";  ///< chords of them cut the loop short

/// The closed cycles of a record, and the counts of those left out.
struct RecordCycles {
  std::vector<RecordCycle> cycles = {};  ///< by their beginning
  std::size_t coarse = 0;                ///< left out: too few samples to resolve the loop
  std::size_t unresolved = 0;            ///< left out: below noise, so that D may be 0
  double smallest = 0.0;                 ///< half range below which they lie, m
  double force_noise = 0.0;  ///< standard deviation of a sample, N; 0 where there is none
  double path_noise = 0.0;   ///< of a displacement, m
};

/// Finds the closed cycles of a record. Turns that noise makes of its path are none, see
/// smooth_path(). A range between two turns is a cycle where those before and behind it are as
/// large (rainflow counting, four points): the sliders that it moves were at their limits at a
/// then. Of the turns that remain at the end, as in a decay, those that come back to within 3 % and
/// began to within 0.5 % form cycles too; the gap of the path to a is closed by a straight line, an
/// error of third order. A record that is one loop from tip to tip has no range before it, and is a
/// cycle where its force comes back. n samples make D too small by a share of 6.6/n².
///
/// Standard deviations are those of independent errors of the samples, σ_F of the force and σ_u of
/// the path, by the flat parts of their spectra, to first order:
///
///     σ² = σ_F² Σ_i (∂/∂F_i)² + σ_u² Σ_i (mean of ∂/∂u over n samples about i)²
///
/// of D and k_eq as sums over the samples of the loop. An error of u acts by the slope dF/du of the
/// loop where it is, by smoothed forces; one of a turn moves A. n = (σ_u/σ_left)² is the number
/// of samples that the smoothing of the path combines. Errors that all samples share, of gains
/// above all, are not included. Cycles no larger than the largest whose D is below three deviations
/// are left out, not those alone whose D happens to be low.
/// @param evidence  of any start.
[[nodiscard]] RecordCycles record_cycles(const RecordEvidence& evidence);

/// All cycles of records as levels, in their order; with standard deviations where all of them have
/// noise.
[[nodiscard]] Levels levels_of_cycles(std::span<const RecordCycles> records);

}  // namespace microslip
